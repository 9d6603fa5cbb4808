# Draws quaternion_step.svg: the step (9), (10) of "Try it" on the sphere of unit quaternions.
height = 270
load 'labs/sketch_style.gp'
set output 'labs/1_rigid_body_kinematics/sketches/quaternion_step.svg'
eval view(0.6, 0.5, 185)
theta = 2.0                # the angle of the step, |ω| dt, in radians
half = 0.5*theta
long = sqrt(1 + half**2)
exact = half*180/pi

eval arc(0, 0, 1, -10, 100, grey)
eval vector(0, 0, 1, 0, ink)
eval vector(1, 0, 0, half, orange)
eval vector(0, 0, 1, half, orange)
eval vector(0, 0, 1/long, half/long, blue)
eval vector(0, 0, cos(exact), sin(exact), green)
eval right_angle(1, 0, 90)
eval arc(0, 0, 0.7, 0, exact, green)
eval arc(0, 0, 0.24, 0, atan(half), blue)
eval label(1, 0, -12, -14, 'q', ink)
eval label(1, 0.5*half, 42, 0, i('dt').' ½ ω q', orange)
eval label(1, half, 8, 14, 'q_{pred}', orange)
eval label(0.86*cos(33), 0.86*sin(33), 0, 0, 'q_{next}', blue)
eval label(cos(exact), sin(exact), -4, 34, 'exp(ω '.i('dt').') q', green)
eval label(0.7*cos(13), 0.7*sin(13), 22, 0, i('θ').'/2', green)
eval label(0.24*cos(18), 0.24*sin(18), 43, 0, 'atan('.i('θ').'/2)', blue)

plot NaN
