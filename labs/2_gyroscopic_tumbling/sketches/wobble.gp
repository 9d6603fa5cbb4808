# Draws wobble.svg: a small wobble about axis 1 for the moments (1, 2, 3), exact and by two steps.
height = 280
load 'labs/sketch_style.gp'
set output 'labs/2_gyroscopic_tumbling/sketches/wobble.svg'
eval view(0, -0.03, 150)
y = 0.35  # Ω_p dt

# With w = √3 ω3 the ellipse is a circle, on which ω2 + i w turns clockwise.
eval thin(-1.25, 0, 1.25, 0, grey)
eval thin(0, -0.78, 0, 0.7, grey)
eval label(1.25, 0, 14, 0, i('ω').'_2', grey)
eval label(0, 0.7, 0, 11, i('ω').'_3', grey)
step(from, to, c) = \
  vector(real(from), imag(from)/sqrt(3), real(to - from), imag(to - from)/sqrt(3), c)
outer = {1, 0}
inner = {1, 0}
do for [k = 1:8] {
  next = outer*(1 - y*{0, 1})
  eval step(outer, next, orange)
  outer = next
  next = inner/(1 + y*{0, 1})
  eval step(inner, next, green)
  inner = next
}
eval dot(1, 0, ink)
eval label(real(outer), imag(outer)/sqrt(3), -30, 16, 'explicit', orange)
eval label(real(inner), imag(inner)/sqrt(3), 34, 12, 'implicit', green)
eval label(cos(60), sin(60)/sqrt(3), 26, 8, 'exact', ink)

plot sample [t=0:360] '+' using (cos($1)):(sin($1)/sqrt(3)) with lines lw 2 lc rgb ink
