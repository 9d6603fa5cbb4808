# Draws polhodes.svg: the paths of m in the body for the moments (1, 2, 3), |m| = 1.
load 'labs/sketch_style.gp'
set output 'labs/2_gyroscopic_tumbling/sketches/polhodes.svg'
eval view(0, 0.15, 112)

# Seen from the direction (azimuth, elevation), the near side only; axis 3 points upwards.
azimuth = 52; elevation = 24
X(a, b, c) = -a*sin(azimuth) + b*cos(azimuth)
Y(a, b, c) = c*cos(elevation) - (a*cos(azimuth) + b*sin(azimuth))*sin(elevation)
near(a, b, c) = c*sin(elevation) + (a*cos(azimuth) + b*sin(azimuth))*cos(elevation)
seen(a, b, c) = near(a, b, c) < 0 ? NaN : X(a, b, c) + {0, 1}*Y(a, b, c)

eval disc(0, 0, 1, pale)
eval ring(0, 0, 1, grey)
array A = [1, 0, 0]
array B = [0, 1, 0]
array C = [0, 0, 1]
do for [k = 1:3] {
  x = X(A[k], B[k], C[k]); y = Y(A[k], B[k], C[k])
  eval dot(x, y, ink)
  eval vector(x, y, 0.35*x, 0.35*y, ink)
  eval label(1.35*x, 1.35*y, x < 0 ? -11 : 11, 5, sprintf('%d', k), ink)
}

rest(u, v) = sqrt(1 - u**2 - v**2)
# 2 E = 1 - K about axis 1 and 1/3 + K about axis 3: two entries of m are on an ellipse.
about_1(u, v) = seen(rest(u, v), u, v)
about_3(u, v) = seen(u, v, rest(u, v))

# Heads point along dm/dt = m × ω.
mark(a, b, c, colour) = vector(X(a, b, c), Y(a, b, c), 0.05*X(-b*c/6, 2*c*a/3, -a*b/2), \
  0.05*Y(-b*c/6, 2*c*a/3, -a*b/2), colour)
do for [K in '0.05 0.18 0.35'] { u = sqrt(2*K); eval mark(rest(u, 0), u, 0, blue) }
do for [K in '0.02 0.06 0.12'] { u = sqrt(1.5*K); eval mark(u, 0, rest(u, 0), green) }
eval mark(0.5*sin(50), cos(50), sqrt(0.75)*sin(50), orange)
eval mark(-0.5*sin(40), cos(40), sqrt(0.75)*sin(40), orange)
eval mark(0.5*sin(50), cos(50), -sqrt(0.75)*sin(50), orange)

plot for [K in '0.05 0.18 0.35'] [t=0:360] '+' \
    using (z = about_1(sqrt(2*K)*cos($1), sqrt(1.5*K)*sin($1)), real(z)):(imag(z)) \
    with lines lw 2 lc rgb blue, \
  for [K in '0.02 0.06 0.12'] [t=0:360] '+' \
    using (z = about_3(sqrt(1.5*K)*cos($1), sqrt(6*K)*sin($1)), real(z)):(imag(z)) \
    with lines lw 2 lc rgb green, \
  for [k = -1:1:2] [t=0:360] '+' \
    using (z = seen(0.5*sin($1), cos($1), k*sqrt(0.75)*sin($1)), real(z)):(imag(z)) \
    with lines lw 2 lc rgb orange
