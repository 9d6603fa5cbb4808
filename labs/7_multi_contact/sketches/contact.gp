# Draws contact.svg: what row i of J is made of, at a contact of two boxes.
height = 260
load 'labs/sketch_style.gp'
set output 'labs/7_multi_contact/sketches/contact.svg'
eval view(-0.05, 0.36, 78)
turn_a = 10; turn_b = 48
ax = -0.5; ay = -0.45; aw = 1.6; ah = 0.48; bw = 0.8; bh = 0.48
px_a = 0.3                              # where b's corner stands on a's upper side
px0 = ax + px_a*cos(turn_a) - ah*sin(turn_a)
py0 = ay + px_a*sin(turn_a) + ah*cos(turn_a)
bx = px0 + bw*cos(turn_b) - bh*sin(turn_b)
by = py0 + bw*sin(turn_b) + bh*cos(turn_b)
nx = -sin(turn_a); ny = cos(turn_a); s = 0.95
eval box(ax, ay, aw, ah, turn_a, bordered(pale_blue, grey))
eval box(bx, by, bw, bh, turn_b, bordered(pale_green, grey))
eval vector(ax, ay, px0 - ax, py0 - ay, ink)
eval vector(bx, by, px0 - bx, py0 - by, ink)
eval vector(px0, py0, s*nx, s*ny, orange)
eval vector(px0, py0, -s*nx, -s*ny, orange)
eval dot(ax, ay, ink)
eval dot(bx, by, ink)
eval dot(px0, py0, ink)
eval label(ax - aw*cos(turn_a), ay - aw*sin(turn_a), 22, 2, 'a', ink)
eval label(bx + bw*cos(turn_b), by + bw*sin(turn_b), -16, -14, 'b', ink)
eval label(0.5*(ax + px0), 0.5*(ay + py0), -14, 8, 'r_a', ink)
eval label(0.5*(bx + px0), 0.5*(by + py0), 16, -8, 'r_b', ink)
eval label(px0 + s*nx, py0 + s*ny, -26, 0, i('λ').' n', orange)
eval label(px0 - s*nx, py0 - s*ny, 32, 16, '−'.i('λ').' n', orange)

plot NaN
