# Draws rod.svg: the rod of "Try it" in 6.5 at its impact, and both parts of K n.
height = 250
load 'labs/sketch_style.gp'
set output 'labs/6_impulse_response/sketches/rod.svg'
eval view(0, 1.1, 76)
m = 1.0; I = 2.0/3; rx = 1.0; rz = -1.0; ux = -3.0; uz = -5.0
set object rectangle from -4,-3 to 4,0 behind fs solid noborder fc rgb pale
eval line(-4, 0, 4, 0, grey)

# An impulse n turns the body at the rate spin about y; in this plane spin × r = spin (rz, -rx).
spin = -rx/I
do for [k = 0:1] {
  x = k == 0 ? -1.6 : 1.55
  eval stroke(x - 2*rx, -2*rz, x, 0, 'nohead lw 7 lc rgb "'.pale.'"')
  eval stroke(x - 2*rx, -2*rz, x, 0, 'nohead lw 1.5 lc rgb "'.grey.'"')
  eval dot(x - rx, -rz, ink)
  eval dot(x, 0, ink)
}
x = -1.6
eval vector(x - rx, -rz, rx, rz, ink)
eval vector(x - 0.22*ux, -0.22*uz, 0.22*ux, 0.22*uz, orange)
x = 1.55
s = 0.85
eval vector(x, 0, 0, s/m, ink)
eval vector(x, s/m, s*spin*rz, -s*spin*rx, blue)
eval vector(x, 0, s*spin*rz, s*(1/m - spin*rx), green)
eval label(-1.6 - 0.5*rx, -0.5*rz, -8, -13, 'r', ink)
eval label(-1.6 - 0.22*ux, -0.22*uz, 10, 6, 'u', orange)
eval label(x, s/m, -22, 6, 'n/'.i('m'), ink)
eval label(x + 0.5*s*spin*rz, s/m - 0.5*s*spin*rx, -22, 10, 'turn', blue)
eval label(x + 0.6*s*spin*rz, 0.6*s*(1/m - spin*rx), 22, -4, 'K n', green)

plot NaN
