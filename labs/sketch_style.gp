# What all sketches of the handouts share: size, font, colours and the words they are drawn with.
# In the project's root, `gnuplot labs/N_name/sketches/NAME.gp` draws NAME.svg beside its script.
# A script loads this file, sets its output, calls eval with view(...) and the words below, and ends
# with `plot`. Lengths are in units of the sketch, angles in degrees, offsets of labels in pixels.
if (!exists('height')) height = 300
set terminal svg size 560,height font 'DejaVu Sans,13' \
  fontscale 1.25 enhanced rounded background '#ffffff'
set encoding utf8
set angles degrees
set margins 0, 0, 0, 0
unset key; unset border; unset tics
set samples 200

# The palette of the charts (render/colour.hpp); letters in orange are darker, as letters are thin.
ink = '#282c34'; grey = '#8c9199'; pale = '#e4e6e9'
blue = '#0072b2'; orange = '#e69f00'; green = '#009e73'
pale_blue = '#d6e8f3'; pale_orange = '#fbeccb'; pale_green = '#d3efe6'
letters(c) = c eq orange ? '#996a00' : c eq grey ? '#6b7078' : c

# The middle of the sketch, and how many pixels a unit has.
view(x, y, scale) = sprintf('px = 1.0/%.9g; set xrange [%.9g:%.9g]; set yrange [%.9g:%.9g]', \
  scale, x - 280.0/scale, x + 280.0/scale, y - 0.5*height/scale, y + 0.5*height/scale)

# Lines: plain, dashed, thin; a vector from a point; a length with a head at both ends.
stroke(x1, y1, x2, y2, look) = \
  sprintf('set arrow from %.9g,%.9g to %.9g,%.9g %s', x1, y1, x2, y2, look)
line(x1, y1, x2, y2, c) = stroke(x1, y1, x2, y2, 'nohead lw 2 lc rgb "'.c.'"')
thin(x1, y1, x2, y2, c) = stroke(x1, y1, x2, y2, 'nohead lw 1 lc rgb "'.c.'"')
dashes(x1, y1, x2, y2, c) = stroke(x1, y1, x2, y2, 'nohead lw 1.5 dt (6,5) lc rgb "'.c.'"')
tip(w, c) = sprintf('filled size %.9g,18 fixed lw %g lc rgb "%s"', 11*px, w, c)
vector(x, y, dx, dy, c) = stroke(x, y, x + dx, y + dy, 'head '.tip(2, c))
span(x1, y1, x2, y2, c) = stroke(x1, y1, x2, y2, 'heads '.tip(1, c))

# Circles: filled, drawn, dashed, an arc of one, a point.
circle(x, y, r, look) = sprintf('set object circle at %.9g,%.9g size %.9g %s', x, y, r, look)
edge(w, c) = sprintf('fs empty border rgb "%s" fc rgb "%s" lw %g', c, c, w)
disc(x, y, r, c) = circle(x, y, r, filled(c))
ring(x, y, r, c) = circle(x, y, r, edge(2, c))
dashed_ring(x, y, r, c) = circle(x, y, r, edge(1.5, c).' dt (6,5)')
arc(x, y, r, from, to, c) = \
  circle(x, y, r, sprintf('arc [%.9g:%.9g] nowedge ', from, to).edge(1.5, c))
dot(x, y, c) = circle(x, y, 4*px, 'front fs solid noborder fc rgb "'.c.'"')

# A box of half sides w and h about a point, turned by `angle`.
box(x, y, w, h, angle, look) = 'set object polygon from '.at(x, y, w, h, angle).' to '. \
  at(x, y, -w, h, angle).' to '.at(x, y, -w, -h, angle).' to '.at(x, y, w, -h, angle).' to '. \
  at(x, y, w, h, angle).' '.look
at(x, y, u, v, angle) = sprintf('%.9g,%.9g', x + u*cos(angle) - v*sin(angle), \
  y + u*sin(angle) + v*cos(angle))
filled(c) = 'behind fs solid noborder fc rgb "'.c.'"'
bordered(fill, c) = 'behind fs solid border rgb "'.c.'" lw 2 fc rgb "'.fill.'"'

# A right angle at a point, between the directions `angle` and `angle` + 90.
right_angle(x, y, angle) = corner(x, y, 9*px*cos(angle), 9*px*sin(angle))
corner(x, y, u, v) = thin(x + u, y + v, x + u - v, y + v + u, ink).'; '. \
  thin(x - v, y + u, x + u - v, y + v + u, ink)

# Words, centred dx, dy pixels beside a point; i(...) sets a scalar. Where the type changes, SVG may
# drop a space; it keeps one that cannot break (U+00A0) beside a word joiner (U+2060).
i(word) = '{/:Italic '.word.'}'
changed(s, a, b) = strstrt(s, a) == 0 ? s : \
  s[1:strstrt(s, a) - 1].b.changed(s[strstrt(s, a) + strlen(a):*], a, b)
spaced(words) = changed(changed(words, '} ', "}\342\201\240\302\240"), ' {', \
  "\302\240\342\201\240{")
label(x, y, dx, dy, words, c) = sprintf('set label "%s" at %.9g,%.9g centre front tc rgb "%s"', \
  spaced(words), x + dx*px, y + dy*px, letters(c))
