# Draws cuts.svg: the four triangles of "Try it", cut by halves and by the sum (8).
height = 225
load 'labs/sketch_style.gp'
set output 'labs/5_bvh_traversal/sketches/cuts.svg'
eval view(6.15, 1.4, 43)
array I = [0, 1, 2, 9]

do for [k = 0:1] {
  z = k == 0 ? 1.9 : -0.2
  left = k == 0 ? 2 : 3  # this many triangles go to the left
  sum = 0
  inset = k == 0 ? 0.03 : 0   # shows both boxes where they touch
  do for [n = 1:4] {
    set object polygon from I[n],z to I[n] + 1,z to I[n],z + 1 to I[n],z \
      behind fs solid border rgb grey lw 1.5 fc rgb pale
  }
  do for [side = 0:1] {
    low = side == 0 ? I[1] : I[left + 1]
    high = (side == 0 ? I[left] : I[4]) + 1
    count = side == 0 ? left : 4 - left
    area = 2*(high - low)  # of a flat box of height 1
    colour = side == 0 ? blue : orange
    sum = sum + area*count
    eval sprintf('set object rectangle from %.9g,%.9g to %.9g,%.9g ', \
      low + inset*side, z - 0.03, high - inset*(1 - side), z + 1.03).edge(2, colour)
    eval label(0.5*(low + high), z + 1, 0, 18, sprintf('%d · %d', area, count), colour)
  }
  eval label(11.2, z + 0.5, 0, 0, sprintf('sum %d', sum), ink)
}
do for [n = 1:4] { eval label(I[n] + 0.5, -0.2, 0, -16, sprintf('%d', I[n]), grey) }
eval label(0, -0.2, -6, -16, i('i'), grey)

plot NaN
