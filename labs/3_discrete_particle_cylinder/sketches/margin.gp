# Draws margin.svg: the distances (7) and (8), at which an edge and a triangle begin to touch.
height = 340
load 'labs/sketch_style.gp'
set output 'labs/3_discrete_particle_cylinder/sketches/margin.svg'
eval view(0, 0, 70)

# On the left, the middle of an edge touches: it is at the distance ρ.
y = -2.35; rho = 1; h = 2.2
d = sqrt(rho**2 + h**2/4)
eval disc(y, 0, rho, pale)
eval ring(y, 0, rho, grey)
eval dashed_ring(y, 0, d, blue)
eval line(y - h/2, rho, y + h/2, rho, ink)
eval thin(y, 0, y, rho, ink)
eval thin(y, 0, y + h/2, rho, blue)
eval right_angle(y, rho, -180)
eval dot(y, 0, ink)
eval dot(y - h/2, rho, ink)
eval dot(y + h/2, rho, ink)
eval span(y, -rho, y, -d, orange)
eval label(y, 0.5*rho, -12, 0, i('ρ'), ink)
eval label(y + h/4, rho, -4, 13, i('h').'/2', ink)
eval label(y, -0.5*(rho + d), 16, 0, i('m'), orange)
eval label(y, d, 0, 20, '√('.i('ρ').'² + '.i('h').'²/4)', blue)

# On the right, the axis is in the middle of an equilateral triangle whose edges do not touch.
y = 1.6; rho = 1.08; h = 4
d = h/sqrt(3)
eval disc(y, 0, rho, pale)
eval ring(y, 0, rho, grey)
eval dashed_ring(y, 0, d, blue)
do for [k = 0:2] {
  a = 90 + 120*k
  eval line(y + d*cos(a), d*sin(a), y + d*cos(a + 120), d*sin(a + 120), ink)
  eval dot(y + d*cos(a), d*sin(a), ink)
}
eval thin(y, 0, y, d, blue)
eval thin(y, 0, y + d*cos(-30), d*sin(-30), blue)
eval thin(y, 0, y, -d/2, ink)
eval right_angle(y, -d/2, 0)
eval arc(y, 0, 0.28, -30, 90, ink)
eval span(y + rho*cos(150), rho*sin(150), y + d*cos(150), d*sin(150), orange)
eval dot(y, 0, ink)
eval label(y + 1.08, -0.93, 0, 0, i('h').'/√3', blue)
eval label(y + 0.28*cos(30), 0.28*sin(30), 24, 4, '120°', ink)
eval label(y, -0.14*d, -35, 0, i('h').'/(2√3)', ink)
eval label(y + d*cos(30)/2, d*sin(30)/2, 12, 10, i('h'), ink)
eval label(y + 1.75*cos(150), 1.75*sin(150), 8, 13, i('m'), orange)

plot NaN
