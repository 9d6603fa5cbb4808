# Draws moved_box.svg: a box, the box moved by R and t, and the box around that by (9).
height = 265
load 'labs/sketch_style.gp'
set output 'labs/5_bvh_traversal/sketches/moved_box.svg'
eval view(0, 0, 62)
cx = -2.8; cy = -0.3; hx = 1.45; hy = 0.7  # centre and half sides
dx = 1.5; dy = 0.25                         # the centre after the move
angle = 33
wide = abs(cos(angle))*hx + abs(sin(angle))*hy  # |R| h
tall = abs(sin(angle))*hx + abs(cos(angle))*hy

eval box(cx, cy, hx, hy, 0, bordered(pale_blue, blue))
eval box(dx, dy, hx, hy, angle, bordered(pale_blue, blue))
eval box(dx, dy, wide, tall, 0, edge(2, orange))
eval span(cx, cy, cx + hx, cy, ink)
eval span(cx, cy, cx, cy + hy, ink)
eval dashes(dx, dy, dx, dy - tall - 0.3, grey)
eval dashes(dx, dy, dx + wide + 0.3, dy, grey)
eval span(dx, dy - tall - 0.2, dx + wide, dy - tall - 0.2, ink)
eval span(dx + wide + 0.2, dy, dx + wide + 0.2, dy + tall, ink)
eval dot(cx, cy, ink)
eval dot(dx, dy, ink)
eval label(cx, cy, -11, -9, 'c', ink)
eval label(cx + 0.5*hx, cy, 0, -13, i('h').'_x', ink)
eval label(cx, cy + 0.5*hy, -14, 0, i('h').'_y', ink)
eval label(dx, dy, -36, -14, 'R c + t', ink)
eval label(dx + 0.5*wide, dy - tall - 0.2, 0, -15, '(|R| h)_x', ink)
eval label(dx + wide + 0.2, dy + 0.5*tall, 36, 0, '(|R| h)_y', ink)

plot NaN
