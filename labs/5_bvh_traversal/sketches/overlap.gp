# Draws overlap.svg: boxes that cross, boxes that are apart along x, and their intervals.
height = 275
load 'labs/sketch_style.gp'
set output 'labs/5_bvh_traversal/sketches/overlap.svg'
eval view(0, 0, 50)
spanned(low_x, low_y, w, h, look) = \
  sprintf('set object rectangle from %.9g,%.9g rto %.9g,%.9g %s', low_x, low_y, w, h, look)
tinted(c) = 'behind fs transparent solid 0.7 noborder fc rgb "'.c.'"'

# Lower left corners, widths and heights of a and b, on the left and on the right.
array Ax = [0.3, 0.3]; array Ay = [1.2, 1.5]; array Aw = [3.5, 1.5]; array Ah = [0.9, 1.7]
array Bx = [1.4, 2.5]; array By = [0.4, 0.5]; array Bw = [1.1, 1.4]; array Bh = [2.7, 1.9]
do for [k = 1:2] {
  x = k == 1 ? -4.6 : 1.0
  y = -1.55
  ax = x + Ax[k]; ay = y + Ay[k]; bx = x + Bx[k]; by = y + By[k]
  eval spanned(ax, ay, Aw[k], Ah[k], tinted(pale_blue))
  eval spanned(bx, by, Bw[k], Bh[k], tinted(pale_orange))
  eval spanned(ax, ay, Aw[k], Ah[k], edge(2, blue))
  eval spanned(bx, by, Bw[k], Bh[k], edge(2, orange))
  eval vector(x - 0.55, y - 0.5, 4.7, 0, grey)
  eval vector(x - 0.55, y - 0.5, 0, 4.3, grey)
  eval label(x + 4.15, y - 0.5, 10, 0, i('x'), grey)
  eval label(x - 0.55, y + 3.8, -11, 0, i('y'), grey)
  eval line(ax, y - 0.1, ax + Aw[k], y - 0.1, blue)
  eval line(bx, y - 0.28, bx + Bw[k], y - 0.28, orange)
  eval line(x - 0.15, ay, x - 0.15, ay + Ah[k], blue)
  eval line(x - 0.33, by, x - 0.33, by + Bh[k], orange)
  eval label(ax + 0.3, ay + Ah[k] - 0.3, 0, 0, 'a', blue)
  eval label(bx + 0.3, by + Bh[k] - 0.3, 0, 0, 'b', orange)
}
eval dashes(ax + Aw[2], ay, ax + Aw[2], y - 0.5, grey)
eval dashes(bx, by, bx, y - 0.5, grey)
eval label(ax + Aw[2], y - 0.5, -16, -14, 'high_a', blue)
eval label(bx, y - 0.5, 14, -14, 'low_b', orange)

plot NaN
