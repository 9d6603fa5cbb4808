# Draws frames.svg: a point of a turned body in the world's frame and in the body's, by (2).
height = 260
load 'labs/sketch_style.gp'
set output 'labs/1_rigid_body_kinematics/sketches/frames.svg'
eval view(0, 0, 62)
angle = 28; w = 1.9; h = 1.15       # the body's turn and half sides
x = 1.75; y = 0.05                  # the centre of mass
ox = -3.9; oy = -1.55               # the world's origin
u = 0.75; v = 0.85                  # p_body
c = cos(angle); s = sin(angle)
X(u, v) = x + u*c - v*s
Y(u, v) = y + u*s + v*c

eval box(x, y, w, h, angle, bordered(pale, grey))
eval vector(ox, oy, 0.8, 0, ink)
eval vector(ox, oy, 0, 0.8, ink)
eval vector(x, y, 0.8*c, 0.8*s, green)
eval vector(x, y, -0.8*s, 0.8*c, green)
eval vector(ox, oy, x - ox, y - oy, ink)
eval vector(ox, oy, X(u, v) - ox, Y(u, v) - oy, ink)
eval vector(x, y, X(u, v) - x, Y(u, v) - y, blue)
eval dot(X(u, v), Y(u, v), ink)
eval dot(x, y, ink)
eval label(0.5*(ox + x), 0.5*(oy + y), 10, -12, 'x', ink)
eval label(0.5*(ox + X(u, v)), 0.5*(oy + Y(u, v)), -8, 14, 'p', ink)
eval label(X(0.5*u, 0.5*v), Y(0.5*u, 0.5*v), 38, 12, 'R p_{body}', blue)
eval label(ox + 0.4, oy, 0, -14, 'world', ink)
eval label(X(0.8, 0), Y(0.8, 0), 22, -13, 'body', green)

plot NaN
