# Draws velocity.svg: the velocities of two corners of a turning body by (4).
height = 250
load 'labs/sketch_style.gp'
set output 'labs/1_rigid_body_kinematics/sketches/velocity.svg'
eval view(1.25, 0.15, 72)
angle = 10; w = 1.7; h = 0.8  # the body's turn and half sides
vx = 1.1; vy = 0.35           # of the centre of mass
omega = 0.75                  # out of the page
X(u, v) = u*cos(angle) - v*sin(angle)
Y(u, v) = u*sin(angle) + v*cos(angle)

eval box(0, 0, w, h, angle, bordered(pale, grey))
do for [k = -1:1:2] {
  rx = X(k*w, -k*h)
  ry = Y(k*w, -k*h)
  eval dashes(0, 0, rx, ry, ink)
  eval vector(rx, ry, vx, vy, green)
  eval vector(rx + vx, ry + vy, -omega*ry, omega*rx, blue)
  eval vector(rx, ry, vx - omega*ry, vy + omega*rx, orange)
  eval dot(rx, ry, ink)
}
eval vector(0, 0, vx, vy, green)
eval dot(0, 0, ink)
eval label(rx, ry, 4, -15, 'p', ink)
eval label(rx + 0.5*vx, ry + 0.5*vy, 6, -14, 'v', green)
eval label(rx + vx - 0.5*omega*ry, ry + vy + 0.5*omega*rx, 64, -2, 'ω × (p − x)', blue)
eval label(rx + vx - omega*ry, ry + vy + omega*rx, 10, 14, 'v + ω × (p − x)', orange)
eval label(0, 0, -6, 14, 'x', ink)
eval label(0.5*vx, 0.5*vy, -4, 14, 'v', green)
eval ring(X(0.2, -0.45), Y(0.2, -0.45), 7*px, ink)
eval circle(X(0.2, -0.45), Y(0.2, -0.45), 2*px, 'fs solid noborder fc rgb ink')
eval label(X(0.2, -0.45), Y(0.2, -0.45), 20, 0, 'ω', ink)

plot NaN
