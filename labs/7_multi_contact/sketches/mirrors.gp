# Draws mirrors.svg: the path of the point of 7.2 between its lines, and straight through their
# mirror images, for M/m = 1.5.
height = 240
load 'labs/sketch_style.gp'
set output 'labs/7_multi_contact/sketches/mirrors.svg'
eval view(0, 0.62, 116)
theta = atan(1/sqrt(1.5))
count = ceil(180/theta) - 1
y0 = 0.5                                # of the path that comes along the lower line
radius(k) = y0/sin(k*theta)             # where it meets line k

# On the left, the angle between the lines; lines of odd number become the upper one.
x = -2.2; far = 1.9
eval line(x, 0, x + far, 0, grey)
eval line(x, 0, x + far*cos(theta), far*sin(theta), grey)
eval arc(x, 0, 0.3, 0, theta, ink)
eval label(x + 0.3*cos(0.5*theta), 0.3*sin(0.5*theta), 12, 0, i('θ'), ink)
X(k) = x + radius(k)*(k % 2 == 0 ? 1 : cos(theta))
Y(k) = radius(k)*(k % 2 == 0 ? 0 : sin(theta))
eval vector(x + far, y0, X(1) - x - far, Y(1) - y0, ink)
do for [k = 1:count] {
  eval label(X(k), Y(k), k % 2 == 0 ? 0 : -7, k % 2 == 0 ? -13 : 12, sprintf('%d', k), blue)
  if (k < count) { eval vector(X(k), Y(k), X(k + 1) - X(k), Y(k + 1) - Y(k), ink) }
}
away = count % 2 == 0 ? 180 - count*theta : (count + 1)*theta - 180
eval vector(X(count), Y(count), 0.65*cos(away), 0.65*sin(away), orange)

# On the right, the lines' mirror images, and the straight path.
x = 1.32
do for [k = 0:count + 1] {
  far = k < 2 ? 1.05 : 1.4
  eval line(x, 0, x + far*cos(k*theta), far*sin(k*theta), k < 2 ? grey : pale)
}
eval vector(x + 1.0, y0, y0/tan(count*theta) - 1.0, 0, ink)
eval vector(x + radius(count)*cos(count*theta), y0, -0.4, 0, orange)
do for [k = 1:count] {
  eval dot(x + radius(k)*cos(k*theta), y0, blue)
  eval label(x + radius(k)*cos(k*theta), y0, 2, 13, sprintf('%d', k), blue)
}
eval arc(x, 0, 0.2, 0, theta, ink)

plot NaN
