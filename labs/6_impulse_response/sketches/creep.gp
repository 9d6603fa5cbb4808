# Draws creep.svg: a particle at rest on a slope of 30 degrees, moved by a step and corrected.
height = 250
load 'labs/sketch_style.gp'
set output 'labs/6_impulse_response/sketches/creep.svg'
angle = 30
eval view(0.35, -0.55, 115)
X(t, n) = t*cos(angle) + n*sin(angle)  # t along the slope, downwards to the right, n out of it
Z(t, n) = -t*sin(angle) + n*cos(angle)
go(t, n, u, w, c) = vector(X(t, n), Z(t, n), X(u, w), Z(u, w), c)
d = 1.35                               # |d| = dt² g
dt = d*sin(angle); dn = d*cos(angle)

set object polygon from X(-4, 0),Z(-4, 0) to X(4, 0),Z(4, 0) to X(4, -6),Z(4, -6) \
  to X(-4, -6),Z(-4, -6) to X(-4, 0),Z(-4, 0) behind fs solid noborder fc rgb pale
eval line(X(-3, 0), Z(-3, 0), X(4, 0), Z(4, 0), grey)
eval thin(X(1.95, 0) - 0.85, Z(1.95, 0), X(1.95, 0), Z(1.95, 0), ink)
eval arc(X(1.95, 0), Z(1.95, 0), 0.6, 180 - angle, 180, ink)
eval label(X(1.95, 0) - 0.6*cos(15), Z(1.95, 0) + 0.6*sin(15), -10, 0, i('θ'), ink)
eval go(1.15, 0, 0, 0.6, orange)
eval label(X(1.15, 0.6), Z(1.15, 0.6), 11, 2, 'n', orange)
eval go(0, 0, dt, -dn, ink)
eval go(dt, -dn, 0, dn, blue)
eval go(dt, 0, -dt, 0, green)
eval right_angle(X(dt, 0), Z(dt, 0), 180 - angle)
eval dot(0, 0, ink)
eval label(0, -0.6*d, -12, 0, 'd', ink)
eval label(X(dt, -0.45*dn), Z(dt, -0.45*dn), 22, -8, 'Δx_n', blue)
eval label(X(0.5*dt, 0), Z(0.5*dt, 0), 14, 12, 'Δx_t', green)

plot NaN
