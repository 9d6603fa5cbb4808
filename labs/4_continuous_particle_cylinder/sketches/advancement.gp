# Draws advancement.svg: the steps of conservative advancement (8) on a plain path and on a tangent.
height = 260
load 'labs/sketch_style.gp'
set output 'labs/4_continuous_particle_cylinder/sketches/advancement.svg'
eval view(0, 0.5, 95)

do for [k = 0:1] {
  y0 = k == 0 ? -1.1 : 1.9   # the axis; ρ = 1
  z = k == 0 ? 0.6 : 1
  y = -1.75
  colour = k == 0 ? blue : orange
  eval disc(y0, 0, 1, pale)
  eval ring(y0, 0, 1, grey)
  eval dot(y0, 0, ink)
  eval thin(y0 + y, z, y0 + 0.75, z, grey)
  do for [n = 1:(k == 0 ? 3 : 7)] {
    d = sqrt(y**2 + z**2)
    toward = atan2(-z, -y)
    eval thin(y0 + y, z, y0 + y/d, z/d, n < 3 ? ink : colour)
    if (n == 1) { eval arc(y0 + y, z, d - 1, toward - 25, 20, colour) }
    if (n > 1) { eval circle(y0 + y, z, d - 1, edge(1, colour)) }
    eval circle(y0 + y, z, (n == 1 ? 4 : 3)*px, 'front fs solid noborder fc rgb "'.colour.'"')
    if (n == 1) { eval label(y0 + 0.5*(y + y/d), 0.5*(z + z/d), -4, -13, i('φ'), ink) }
    if (n == 3 && k == 1) { l = y }
    y = y + d - 1
  }
}
eval dot(y0, z, ink)
eval thin(y0 + l, z, y0 + l, 1.42, ink)
eval thin(y0, z, y0, 1.42, ink)
eval span(y0 + l, 1.36, y0, 1.36, ink)
eval label(y0 + 0.5*l, 1.36, 0, 13, i('ℓ'), ink)

plot NaN
