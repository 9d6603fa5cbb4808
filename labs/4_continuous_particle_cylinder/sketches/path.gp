# Draws path.svg: the path of a particle's centre, the disc of radius ρ, and the place of impact.
height = 310
load 'labs/sketch_style.gp'
set output 'labs/4_continuous_particle_cylinder/sketches/path.svg'
eval view(-1.3, 0.18, 88)
R = 1; r = 0.4; beta = 0.8; angle = 6
rho = R + r
half = sqrt(rho**2 - beta**2)
c = cos(angle); s = sin(angle)
Y(along, across) = along*c - across*s  # along the path from its foot, and from the axis
Z(along, across) = along*s + across*c
start = -3.7

eval disc(0, 0, R, pale)
eval ring(0, 0, R, grey)
eval dashed_ring(0, 0, rho, grey)
eval thin(Y(start, beta), Z(start, beta), Y(half + 0.45, beta), Z(half + 0.45, beta), grey)
do for [k = 0:1] {
  y = Y(k == 0 ? start : -half, beta)
  z = Z(k == 0 ? start : -half, beta)
  eval thin(0, 0, y, z, ink)
  eval ring(y, z, r, k == 0 ? ink : blue)
}
eval dashes(0, 0, Y(0, beta), Z(0, beta), ink)
eval line(Y(-half, beta), Z(-half, beta), Y(0, beta), Z(0, beta), blue)
eval right_angle(Y(0, beta), Z(0, beta), angle - 90)
eval vector(Y(start, beta), Z(start, beta), 0.95*c, 0.95*s, orange)
eval dot(0, 0, ink)
eval dot(Y(start, beta), Z(start, beta), ink)
eval dot(y, z, blue)
eval label(Y(start, beta), Z(start, beta), -2, 16, 'x', ink)
eval label(Y(start + 0.75, beta), Z(start + 0.75, beta), 0, 15, 'v', orange)
eval label(Y(0.5*start, 0.5*beta), Z(0.5*start, 0.5*beta), -26, -15, '|x|', ink)
eval label(0.5*y, 0.5*z, -6, -12, i('ρ'), ink)
eval label(Y(0, 0.5*beta), Z(0, 0.5*beta), 12, 0, i('β'), ink)
eval label(y, z, -16, 48, 'x + '.i('t').'* v', blue)
eval thin(-0.3, 1.08, Y(-0.4*half, beta), Z(-0.4*half, beta), blue)
eval label(0, 1.2, 0, 0, '√('.i('ρ').'² − '.i('β').'²)', blue)
eval thin(0, 0, R*cos(-40), R*sin(-40), ink)
eval label(0.5*R*cos(-40), 0.5*R*sin(-40), -7, -10, i('R'), ink)
y = Y(start, beta); z = Z(start, beta)
eval thin(y, z, y + r*cos(-110), z + r*sin(-110), ink)
eval label(y + 0.5*r*cos(-110), z + 0.5*r*sin(-110), 9, -4, i('r'), ink)

plot NaN
