# Draws descent.svg: the boxes of two small trees, and the pairs that the traversal (6) looks at.
height = 260
load 'labs/sketch_style.gp'
set output 'labs/5_bvh_traversal/sketches/descent.svg'
eval view(0, 0, 40)

# Low and high corners of node k of a and of b, at index k + 1: 0 is the root, 1 and 2 are leaves.
array Al = [{-6.5, -2.1}, {-6.5, -1.8}, {-4.1, -2.1}]
array Ah = [{-2.5,  0.5}, {-4.6,  0.5}, {-2.5, -0.3}]
array Bl = [{-3.4, -1.2}, {-3.4, -0.8}, {-1.8, -1.2}]
array Bh = [{-0.5,  1.6}, {-2.1,  1.6}, {-0.5,  0.4}]
meet(i, k) = real(Al[i]) <= real(Bh[k]) && real(Bl[k]) <= real(Ah[i]) && \
  imag(Al[i]) <= imag(Bh[k]) && imag(Bl[k]) <= imag(Ah[i])
spanned(low, high, look) = sprintf('set object rectangle from %.9g,%.9g to %.9g,%.9g ', real(low), \
  imag(low), real(high), imag(high)).look
tinted(c) = 'behind fs transparent solid 0.7 noborder fc rgb "'.c.'"'

do for [k = 3:1:-1] {
  if (k > 1) {
    eval spanned(Al[k], Ah[k], tinted(pale_blue))
    eval spanned(Bl[k], Bh[k], tinted(pale_orange))
    eval label(real(Al[k]), imag(Ah[k]), 12, -13, sprintf('%d', k - 1), blue)
    eval label(real(Bh[k]), imag(Bh[k]), -12, -13, sprintf('%d', k - 1), orange)
  }
  eval spanned(Al[k], Ah[k], edge(k == 1 ? 2.5 : 1.5, blue))
  eval spanned(Bl[k], Bh[k], edge(k == 1 ? 2.5 : 1.5, orange))
}
eval label(-6.5, 0.5, 6, 14, 'a', blue)
eval label(-0.5, 1.6, -6, 14, 'b', orange)

# Pairs of nodes, the pair that each comes from, and where it is drawn.
array Pa = [0, 1, 2, 2, 2]
array Pb = [0, 0, 0, 1, 2]
array From = [1, 1, 1, 3, 3]
array At = [{2.5, 2}, {1.0, 0.1}, {4.0, 0.1}, {2.6, -1.8}, {5.4, -1.8}]
do for [p = 1:5] {
  x = real(At[p]); y = imag(At[p])
  inner = Pa[p] == 0 || Pb[p] == 0
  c = !meet(Pa[p] + 1, Pb[p] + 1) ? grey : inner ? ink : green
  eval line(real(At[From[p]]), imag(At[From[p]]), x, y, grey)
  eval spanned(At[p] - {0.75, 0.36}, At[p] + {0.75, 0.36}, 'front fs solid border rgb "'.c. \
    '" lw 2 fc rgb "#ffffff"')
  eval label(x, y, 0, 0, sprintf('(%d, %d)', Pa[p], Pb[p]), c)
  if (c ne ink) { eval label(x, y, 0, -26, c eq green ? 'end' : 'apart', c) }
}
eval label(2.5, 2, 80, 0, 'a is bigger', ink)
eval label(4.0, 0.1, 74, 0, 'a is a leaf', ink)

plot NaN
