# Draws triangles.svg: both crossings of "Try it", and the intervals on the line of the planes.
height = 230
load 'labs/sketch_style.gp'
set output 'labs/5_bvh_traversal/sketches/triangles.svg'
eval view(0, -1.42, 41.5)

# Triangle a is in the plane z = 0 and b in the plane x = y; `azimuth` and `elevation` of the eye.
azimuth = -14; elevation = 35
X(x, y, z) = x0 - x*sin(azimuth) + y*cos(azimuth)
Y(x, y, z) = z*cos(elevation) - (x*cos(azimuth) + y*sin(azimuth))*sin(elevation)
part(x1, y1, z1, x2, y2, z2) = sprintf('%.9g,%.9g to %.9g,%.9g', X(x1, y1, z1), Y(x1, y1, z1), \
  X(x2, y2, z2), Y(x2, y2, z2))
bar(from, to, z, c) = stroke(x0 + from, z, x0 + to, z, 'nohead lw 4 lc rgb "'.c.'"')

do for [k = 0:1] {
  x0 = k == 0 ? -6.45 : 0.35
  s = k == 0 ? 1 : 3  # the corners of b are (s, s, -1), (s, s, 1) and (5, 5, 1)
  e = 0.5*(s + 5)     # where its lower edge meets the plane z = 0
  eval 'set object polygon from '.part(0, 0, 0, 4, 0, 0).' to '.part(0, 4, 0, 0, 0, 0). \
    ' behind fs solid border rgb blue lw 2 fc rgb pale_blue'
  eval 'set object polygon from '.part(s, s, 0, s, s, 1).' to '.part(5, 5, 1, e, e, 0). \
    ' to '.part(s, s, 0, s, s, 0).' back fs transparent solid 0.6 noborder fc rgb pale_orange'
  eval 'set arrow from '.part(-0.2, -0.2, 0, 5.2, 5.2, 0).' nohead lw 1 lc rgb grey'
  eval 'set arrow from '.part(s, s, 0, s, s, 1).' nohead lw 2 lc rgb orange'
  eval 'set arrow from '.part(s, s, 1, 5, 5, 1).' nohead lw 2 lc rgb orange'
  eval 'set arrow from '.part(5, 5, 1, e, e, 0).' nohead lw 2 lc rgb orange'
  eval dashes(X(s, s, 0), Y(s, s, 0), X(s, s, -1), Y(s, s, -1), orange)
  eval dashes(X(s, s, -1), Y(s, s, -1), X(e, e, 0), Y(e, e, 0), orange)
  eval label(X(0, 4, 0), Y(0, 4, 0), 12, 0, 'a', blue)
  eval label(X(s, s, -1), Y(s, s, -1), -11, -3, '−', orange)
  eval label(X(s, s, 1), Y(s, s, 1), -11, 3, '+', orange)
  eval label(X(5, 5, 1), Y(5, 5, 1), 4, 12, '+', orange)
  eval label(X(4, 4, 1), Y(4, 4, 1), 6, 14, 'b', orange)
  eval thin(x0, -3.3, x0 + 5.5, -3.3, grey)
  eval bar(0, 2, -3.22, blue)
  eval bar(s, e, -3.38, orange)
  eval label(x0 + 1, -3.22, 0, 12, 'a', blue)
  eval label(x0 + 0.5*(s + e), -3.38, 0, -13, 'b', orange)
}

plot NaN
