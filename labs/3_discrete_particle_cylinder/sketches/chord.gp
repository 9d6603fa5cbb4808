# Draws chord.svg: samples at the pitch s on a path at the distance β, in two positions.
height = 235
load 'labs/sketch_style.gp'
set output 'labs/3_discrete_particle_cylinder/sketches/chord.svg'
eval view(0, 0.17, 70)
beta = 0.8; s = 2  # in units of ρ
half = sqrt(1 - beta**2)

do for [k = 0:1] {
  y = k == 0 ? -2.05 : 1.95
  first = k == 0 ? y - 1.7 : y - 1.05
  eval disc(y, 0, 1, pale)
  eval ring(y, 0, 1, grey)
  eval vector(y - 1.9, beta, 3.7, 0, grey)
  eval stroke(y - half, beta, y + half, beta, 'nohead lw 4 lc rgb "'.blue.'"')
  eval span(first, 1.25, first + s, 1.25, ink)
  eval thin(first, beta, first, 1.35, ink)
  eval thin(first + s, beta, first + s, 1.35, ink)
  eval dot(first, beta, ink)
  eval dot(first + s, beta, k == 0 ? green : ink)
  eval label(first + 0.5*s, 1.25, 0, 11, i('s'), ink)
  eval label(y - 0.5*half, beta, 0, -13, i('L'), blue)
}
y = -2.05
eval thin(y, 0, y, beta, ink)
eval thin(y, 0, y + half, beta, ink)
eval right_angle(y, beta, -90)
eval dot(y, 0, ink)
eval label(y, 0.5*beta, -10, -6, i('β'), ink)
eval label(y + 0.5*half, 0.5*beta, 10, -6, i('ρ'), ink)
eval dot(1.95, 0, ink)
eval label(y, 0, 0, -22, 'found', ink)
eval label(1.95, 0, 0, -22, 'missed', ink)

plot NaN
