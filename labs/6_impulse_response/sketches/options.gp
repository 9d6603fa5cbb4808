# Draws options.svg: the step of "Try it" in 6.4 by option 2, on the left, and by option 1.
height = 285
load 'labs/sketch_style.gp'
set output 'labs/6_impulse_response/sketches/options.svg'
eval view(0, -0.27, 160)
z0 = 0.5; vx = 3.0; vz = -4.0; g = 8.0; dt = 0.25; e = 0.5; mu = 0.25
set object rectangle from -2,-2 to 2,0 behind fs solid noborder fc rgb pale
eval line(-2, 0, 2, 0, grey)

# Option 2: the whole step d, then both corrections.
x = -1.35
dx = dt*vx
dz = dt*(vz - dt*g)
depth = -(z0 + dz)
back = mu*depth < dx ? mu*depth : dx
eval vector(x, z0, dx, dz, ink)
eval vector(x + dx, -depth, 0, depth, blue)
eval vector(x + dx, 0, -back, 0, green)
eval dot(x, z0, ink)
eval dot(x + dx - back, 0, orange)
eval vector(x + dx - back, 0, 0.1*(vx - mu*(1 + e)*(dt*g - vz)), -0.1*e*(vz - dt*g), orange)
eval label(x + dx - back, 0.3, 24, 0, 'v', orange)
eval label(x + 0.6*dx, z0 + 0.6*dz, -13, -4, 'd', ink)
eval label(-1.4, -1.0, 0, 0, 'option 2', ink)
eval label(x + dx, -0.5*depth, 23, 0, 'Δx_n', blue)
eval label(x + dx - 0.5*back, 0, 8, 15, 'Δx_t', green)

# Option 1: free flight to the impact, its impulses, and free flight for the rest.
x = 0.55
hit = (vz + sqrt(vz**2 + 2*g*z0))/g
rest = dt - hit
speed = -(vz - g*hit)                    # of the impact, along the normal
ux = vx - mu*(1 + e)*speed               # it slips: friction is μ j_n
eval dot(x, z0, ink)
eval dot(x + hit*vx, 0, ink)
eval dot(x + hit*vx + rest*ux, rest*(e*speed - 0.5*g*rest), orange)
uz = e*speed - g*rest
eval vector(x + hit*vx + rest*ux, rest*(uz + 0.5*g*rest), 0.1*ux, 0.1*uz, orange)
eval label(x + hit*vx + rest*ux + 0.1*ux, rest*(uz + 0.5*g*rest) + 0.1*uz, 12, 4, 'v', orange)
eval label(x + hit*vx, 0, 0, -16, 'impact', ink)
eval label(x + hit*vx, -1.0, 0, 0, 'option 1', ink)
plot sample [t=0:hit] '+' using (x + vx*$1):(z0 + vz*$1 - 0.5*g*$1**2) with lines lw 2 lc rgb ink, \
  [t=0:rest] '+' using (x + hit*vx + ux*$1):(e*speed*$1 - 0.5*g*$1**2) with lines lw 2 lc rgb orange
