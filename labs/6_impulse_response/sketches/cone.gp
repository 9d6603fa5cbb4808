# Draws cone.svg: the impact of "Try it" in 6.1 and 6.2, and its impulses in the friction cones.
height = 245
load 'labs/sketch_style.gp'
set output 'labs/6_impulse_response/sketches/cone.svg'
eval view(0, 2.08, 37)
m = 2; vx = 3; vz = -4; e = 0.5
jn = -(1 + e)*m*vz
jt(mu) = -(mu*jn < m*vx ? mu*jn : m*vx)
ground(x, from, to) = sprintf('set object rectangle from %.9g,-0.4 to %.9g,0 ', x + from, x + to). \
  'behind fs solid noborder fc rgb "'.pale.'"; '.line(x + from, 0, x + to, 0, grey)

# On the left, velocities with μ = 1/4.
x = -3.6
eval ground(x, -3.7, 3)
eval vector(x - vx, -vz, vx, 0, green)
eval vector(x, -vz, 0, vz + 4*px, green)
eval vector(x - vx, -vz, vx, vz, ink)
eval vector(x, 0, vx + jt(0.25)/m, vz + jn/m, blue)
eval vector(x + 2.2, 0, 0, 1, orange)
eval label(x + 2.2, 1, 10, -4, 'n', orange)
eval label(x - 0.5*vx, -vz, 0, 12, 'v_t', green)
eval label(x, -0.6*vz, 20, 0, i('v').'_{n} n', green)
eval label(x - 0.5*vx, -0.5*vz, -12, -8, 'v', ink)
eval label(x + vx + jt(0.25)/m, vz + jn/m, 26, 12, 'v + j/'.i('m'), blue)
eval dot(x, 0, ink)

# On the right, impulses, a third as long.
x = 3.45; s = 1.0/3; top = s*jn
eval ground(x, -3.3, 3.5)
do for [k = 0:1] {
  w = top*(k == 0 ? 0.75 : 0.25)
  set object polygon from x,0 to x - w,top to x + w,top to x,0 \
    behind fs solid noborder fc rgb k == 0 ? pale_green : pale_blue
}
eval vector(x, 0, 0, s*jn, ink)
eval vector(x, 0, s*jt(0.25), s*jn, blue)
eval vector(x, 0, s*jt(0.75), s*jn, green)
eval dashes(x, s*jn, x - s*m*vx, s*jn, grey)
eval dot(x, 0, ink)
eval label(x, top, -4, 14, i('j').'_{n} n', ink)
eval label(x - s*m*vx, top, -4, 14, '−'.i('m').' v_t', ink)
eval label(x + 0.25*top, top, 12, 14, i('μ').' = ¼', blue)
eval label(x + 0.75*top, top, 12, 14, i('μ').' = ¾', green)

plot NaN
