# Draws sweeps.svg: the first sweeps of "Try it" in 7.3 on the level lines of f.
height = 290
load 'labs/sketch_style.gp'
set output 'labs/7_multi_contact/sketches/sweeps.svg'
eval view(0, 0, 1)

# A panel: its origin and scale in pixels. On the left the row, on the right the dumb-bell.
array X0[2] = [-245, 20]
array Y0[2] = [-110, -60]
array S[2] = [235, 118]
X(k, u) = X0[k] + S[k]*u
Y(k, v) = Y0[k] + S[k]*v

# The lowest point, and the slopes of A along (1, 1) and (1, -1): level lines are ellipses.
array U[2] = [2.0/3, 1.75]
array V[2] = [1.0/3, -0.5]
array along[2] = [1, 2]
array across[2] = [3, 2.0/3]
ex(k, c, t) = X(k, U[k] + sqrt(c/along[k])*cos(t) + sqrt(c/across[k])*sin(t))
ey(k, c, t) = Y(k, V[k] + sqrt(c/along[k])*cos(t) - sqrt(c/across[k])*sin(t))

array A11[2] = [2.0, 4.0/3]
array A12[2] = [-1.0, 2.0/3]
array B1[2] = [-1.0, -2.0]
array B2[2] = [0.0, -0.5]
array first[2] = [0.0, 1.0]
array right_end[2] = [1.0, 2.05]
array top_end[2] = [0.85, 1.35]
array names[2] = ['row', 'dumb-bell']
above(z) = z < 0 ? 0 : z
do for [k = 1:2] {
  if (k == 2) {
    set object rectangle from X(k, 0),Y(k, -0.68) to X(k, right_end[k]),Y(k, 0) behind \
      fs solid noborder fc rgb pale
  }
  eval stroke(X(k, 0), Y(k, 0), X(k, right_end[k]), Y(k, 0), 'head '.tip(1, grey))
  eval stroke(X(k, 0), Y(k, 0), X(k, 0), Y(k, top_end[k]), 'head '.tip(1, grey))
  u = first[k]; v = first[k]
  eval dot(X(k, u), Y(k, v), ink)
  do for [sweep = 1:3] {
    next = above(u - (A11[k]*u + A12[k]*v + B1[k])/A11[k])
    if (next != u) { eval vector(X(k, u), Y(k, v), S[k]*(next - u), 0, blue) }
    u = next
    next = above(v - (A12[k]*u + A11[k]*v + B2[k])/A11[k])
    if (next != v) { eval vector(X(k, u), Y(k, v), 0, S[k]*(next - v), blue) }
    v = next
  }
  eval dot(X(k, k == 1 ? U[k] : 1.5), Y(k, k == 1 ? V[k] : 0), orange)
  eval label(X(k, right_end[k]), Y(k, 0), -4, -14, i('λ').'_0', ink)
  eval label(X(k, 0), Y(k, top_end[k]), 16, -4, i('λ').'_1', ink)
  eval label(X(k, 0.5*right_end[k]), 125, 0, 0, names[k], ink)
}
plot for [k = 1:2] for [c in '0.02 0.08 0.18 0.32 0.5 0.72 0.98'] [t=0:360] '+' \
  using (x = ex(k, (k == 1 ? 0.3 : 1.6)*c, $1), y = ey(k, (k == 1 ? 0.3 : 1.6)*c, $1), \
    x < X0[k] || x > X(k, right_end[k]) || y > Y(k, top_end[k]) \
    || y < Y(k, k == 1 ? 0 : -0.68) ? NaN : x):(y) \
    with lines lw 1 lc rgb grey
