# Draws limits.svg: the pair of "Try it" in 7.7, and the nearest one within each of three bounds.
height = 235
load 'labs/sketch_style.gp'
set output 'labs/7_multi_contact/sketches/limits.svg'
eval view(0.1, -0.3, 28)
l = 2.5; t = -3; s = -4
size = sqrt(t**2 + s**2)
array near_t[3] = [t*l/size, -l, -0.75]
array near_s[3] = [s*l/size, -l, -1.75]
array names[3] = ['disc', 'box', 'diamond']
do for [k = 1:3] {
  x = 6.4*(k - 2)
  if (k == 1) { eval circle(x, 0, l, bordered(pale_blue, blue)) }
  if (k == 2) { eval box(x, 0, l, l, 0, bordered(pale_blue, blue)) }
  if (k == 3) { eval box(x, 0, l/sqrt(2), l/sqrt(2), 45, bordered(pale_blue, blue)) }
  eval thin(x - 2.8, 0, x + 2.8, 0, grey)
  eval thin(x, -2.8, x, 2.8, grey)
  eval vector(x, 0, near_t[k], near_s[k], ink)
  eval dashes(x + t, s, x + near_t[k], near_s[k], orange)
  eval dot(x + t, s, orange)
  eval dot(x + near_t[k], near_s[k], ink)
  eval label(x, 2.8, 0, 14, names[k], ink)
  eval label(x + 2.8, 0, 8, 0, 't', ink)
  eval label(x, 2.1, k == 3 ? 18 : 9, 0, 's', ink)
}

plot NaN
