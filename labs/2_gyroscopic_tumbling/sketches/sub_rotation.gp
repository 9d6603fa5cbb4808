# Draws sub_rotation.svg: a turn about an axis of the body, in the world and in the body.
height = 250
load 'labs/sketch_style.gp'
set output 'labs/2_gyroscopic_tumbling/sketches/sub_rotation.svg'
eval view(0, 0, 80)
w = 1.0; h = 0.55      # half sides of the body
alpha = 2*atan(0.45)   # tan(alpha/2) = ½ ω_i dt
start = -25            # the direction of m at the start
m = 1.4

# On the left the body turns by alpha, and L rests. On the right, in the body, m turns back.
do for [k = 0:1] {
  x = k == 0 ? -1.75 : 1.65
  a = k == 0 ? alpha : 0
  eval box(x, 0, w, h, a, bordered(pale, grey))
  eval vector(x, 0, 0.75*cos(a), 0.75*sin(a), green)
  eval vector(x, 0, -0.75*sin(a), 0.75*cos(a), green)
  eval dot(x, 0, ink)
}
x = -1.75
eval box(x, 0, w, h, 0, edge(1.5, grey).' dt (6,5)')
eval dashes(x, 0, x + 0.75, 0, green)
eval arc(x, 0, 0.55, 0, alpha, blue)
eval label(x + 0.55*cos(0.5*alpha), 0.55*sin(0.5*alpha), 11, 2, 'p', blue)
eval vector(x, 0, m*cos(start), m*sin(start), orange)
eval label(x + m*cos(start), m*sin(start), 12, -2, 'L', orange)
eval label(x, 0, 0, -112, 'world', ink)
x = 1.65
eval dashes(x, 0, x + m*cos(start), m*sin(start), orange)
eval arc(x, 0, 0.75, start - alpha, start, blue)
eval label(x + 0.75*cos(start - 0.5*alpha), 0.75*sin(start - 0.5*alpha), 9, -9, 'p', blue)
eval vector(x, 0, m*cos(start - alpha), m*sin(start - alpha), orange)
eval label(x + m*cos(start), m*sin(start), 13, -2, 'm', orange)
eval label(x + m*cos(start - alpha), m*sin(start - alpha), 15, 2, 'm′', orange)
eval label(x, 0, -40, -112, 'body', ink)

plot NaN
