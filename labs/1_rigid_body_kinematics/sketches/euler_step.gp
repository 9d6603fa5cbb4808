# Draws euler_step.svg: a step of (7) on a unit vector across ω with its repair (8), and ten steps.
height = 250
load 'labs/sketch_style.gp'
set output 'labs/1_rigid_body_kinematics/sketches/euler_step.svg'
eval view(0, -0.15, 190)

# On the left, one step by the angle θ; the step's length is θ in radians.
x = -1.4; y = -0.55; angle = 50
theta = angle*pi/180
long = sqrt(1 + theta**2)
eval arc(x, y, 1, -8, 72, grey)
eval vector(x, y, 1, 0, ink)
eval vector(x + 1, y, 0, theta, orange)
eval vector(x, y, 1, theta, orange)
eval vector(x, y, 1/long, theta/long, blue)
eval vector(x, y, cos(angle), sin(angle), green)
eval right_angle(x + 1, y, 90)
eval arc(x, y, 0.7, 0, angle, green)
eval arc(x, y, 0.34, 0, atan(theta), blue)
eval label(x + 0.5, y, 0, -13, '1', ink)
eval label(x + 1, y + 0.5*theta, 12, 0, i('θ'), orange)
eval label(x + 1, y + theta, 4, 14, '√(1 + '.i('θ').'²)', orange)
eval label(x + 0.7*cos(15), y + 0.7*sin(15), 13, 0, i('θ'), green)
eval label(x + 0.34*cos(15), y + 0.34*sin(15), 33, 0, 'atan '.i('θ'), blue)

# On the right, ten steps by 24 degrees.
x = 0.85; y = -0.1; scale = 0.32; angle = 24
theta = angle*pi/180
long = 1
eval ring(x, y, scale, grey)
eval dot(x, y, ink)
do for [k = 0:9] {
  c = scale*long*cos(k*atan(theta)); s = scale*long*sin(k*atan(theta))
  eval thin(x, y, x + c, y + s, grey)
  eval vector(x + c, y + s, -theta*s, theta*c, orange)
  long = long*sqrt(1 + theta**2)
}

plot NaN
