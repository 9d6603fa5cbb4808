# Draws top.svg: the torque of the weight on a top that stands on its tip, and its axis' circle.
height = 300
load 'labs/sketch_style.gp'
set output 'labs/2_gyroscopic_tumbling/sketches/top.svg'
eval view(0.1, 0.82, 130)

# Seen from `elevation` above; e is the axis, u and v are across it.
elevation = 20; lean = 42; azimuth = -38
X(a, b, c) = a
Y(a, b, c) = b*sin(elevation) + c*cos(elevation)
ex = sin(lean)*cos(azimuth); ey = sin(lean)*sin(azimuth); ez = cos(lean)
ux = cos(lean)*cos(azimuth); uy = cos(lean)*sin(azimuth); uz = -sin(lean)
vx = -sin(azimuth); vy = cos(azimuth)
far = 1.75     # of the arrow's head from the tip; the centre of mass is at 1
radius = 0.52  # of the disc
x = X(ex, ey, ez); y = Y(ex, ey, ez)

# T = mgl e × down = mgl (-ey, ex, 0).
eval dashes(0, 0, 0, Y(0, 0, 1.7), grey)
eval line(0, 0, x, y, green)
eval vector(x, y, (far - 1)*x, (far - 1)*y, green).' front'
eval vector(x, y, 0, Y(0, 0, -0.62), ink).' front'
eval vector(far*x, far*y, 0.9*X(-ey, ex, 0), 0.9*Y(-ey, ex, 0), orange)
eval dot(x, y, ink)
eval dot(0, 0, ink)
eval label(far*x, far*y, -6, 16, 'e_z', green)
eval label(far*x + 0.9*X(-ey, ex, 0), far*y + 0.9*Y(-ey, ex, 0), 14, 0, 'T', orange)
eval label(x, y - 0.6*cos(elevation), 28, 0, 'down', ink)
eval label(0, 0, -24, 0, 'tip', ink)

rim_x(t) = X(ex + radius*(ux*cos(t) + vx*sin(t)), 0, 0)
rim_y(t) = Y(0, ey + radius*(uy*cos(t) + vy*sin(t)), ez + radius*uz*cos(t))
plot sample \
  [t=0:360] '+' using (rim_x($1)):(rim_y($1)) with filledcurves closed fc rgb pale, \
  [t=0:360] '+' using (rim_x($1)):(rim_y($1)) with lines lw 2 lc rgb grey, \
  [t=0:360] '+' using (far*sin(lean)*cos($1)):(Y(0, far*sin(lean)*sin($1), far*ez)) \
    with lines lw 1.5 dt (6,5) lc rgb grey
