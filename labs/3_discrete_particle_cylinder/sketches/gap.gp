# Draws gap.svg: the gap of a particle outside the cylinder, and both points of a contact.
load 'labs/sketch_style.gp'
set output 'labs/3_discrete_particle_cylinder/sketches/gap.svg'
eval view(2.2, 0.1, 75)
y(t) = t*cos(angle)
z(t) = t*sin(angle)

# On the left, a particle at the distance d from the axis.
R = 1.0; r = 0.4; d = 2.2; angle = 32
eval disc(0, 0, R, pale)
eval ring(0, 0, R, grey)
eval dashed_ring(0, 0, R + r, grey)
eval ring(y(d), z(d), r, ink)
eval line(0, 0, y(R), z(R), ink)
eval line(y(d - r), z(d - r), y(d), z(d), ink)
eval span(y(R), z(R), y(d - r), z(d - r), blue)
eval vector(y(d), z(d), y(0.9), z(0.9), orange)
eval dot(0, 0, ink)
eval dot(y(d), z(d), ink)
eval label(y(0.5*R), z(0.5*R), 6, -13, i('R'), ink)
eval label(y(d - 0.5*r), z(d - 0.5*r), 7, -10, i('r'), ink)
eval label(y(1.63), z(1.63), 8, -14, i('φ'), blue)
eval label(y(d + 0.75), z(d + 0.75), -7, 14, 'n', orange)
eval label(y(d), z(d), -7, 12, 'p', ink)
angle = 160
eval thin(0, 0, y(R + r), z(R + r), ink)
eval label(y(0.6*R), z(0.6*R), 4, 12, i('ρ'), ink)
eval vector(-1.4, -1.7, 0.45, 0, grey)
eval vector(-1.4, -1.7, 0, 0.45, grey)
eval label(-0.95, -1.7, 10, 0, i('y'), grey)
eval label(-1.4, -1.25, 0, 11, i('z'), grey)

# On the right, larger, one that has sunk in.
R = 2; r = 0.8; d = 2.3
y = 4.05; z = -1.4
eval disc(y, z, R, pale)
eval ring(y, z, R, grey)
eval ring(y, z + d, r, ink)
eval dashes(y, z, y, z + d - r, grey)
eval span(y, z + R, y, z + d - r, blue)
eval thin(y, z + R, y + 1, z + R, ink)
eval thin(y, z + d - r, y + 0.4, z + d - r - 0.25, ink)
eval vector(y, z + d, 0, 1, orange)
eval dot(y, z, ink)
eval dot(y, z + d, ink)
eval dot(y, z + R, ink)
eval dot(y, z + d - r, ink)
eval label(y, z + d + 0.9, -12, 0, 'n', orange)
eval label(y, z + d, -12, 6, 'p', ink)
eval label(y, z + R - 0.25, -20, 0, '−'.i('φ'), blue)
eval label(y + 1, z + R, 18, 0, i('R').' n', ink)
eval label(y + 0.4, z + d - r - 0.25, 38, -3, 'p − '.i('r').' n', ink)

plot NaN
