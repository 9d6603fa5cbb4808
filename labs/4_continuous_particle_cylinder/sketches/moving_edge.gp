# Draws moving_edge.svg: the edge of "Try it", and one that turns, each at the start and at t*.
height = 290
load 'labs/sketch_style.gp'
set output 'labs/4_continuous_particle_cylinder/sketches/moving_edge.svg'
eval view(0, 5, 23.5)
rho = 5

# Ends and velocities on the left and on the right; y is relative to the axis.
array Ay = [-3, -5.4]; array Az = [10, 7.2]; array By = [3, 4.2]; array Bz = [10, 9.2]
array Uy = [0, 0.75]; array Uz = [-1, -0.1]; array Vy = [0, 0]; array Vz = [-1, -1]
py(t) = Ay[k] + t*Uy[k]
pz(t) = Az[k] + t*Uz[k]
qy(t) = By[k] + t*Vy[k]
qz(t) = Bz[k] + t*Vz[k]
f(t) = (py(t)*qz(t) - pz(t)*qy(t))**2 - rho**2*((qy(t) - py(t))**2 + (qz(t) - pz(t))**2)

do for [k = 1:2] {
  y0 = k == 1 ? -6.1 : 6.2
  eval disc(y0, 0, rho, pale)
  eval ring(y0, 0, rho, grey)
  eval dot(y0, 0, ink)
  low = 0; high = k == 1 ? 5.9 : 6.5
  do for [n = 1:60] { t = 0.5*(low + high); if (f(t) > 0) { low = t } else { high = t } }
  ey = qy(t) - py(t); ez = qz(t) - pz(t)
  foot = -(py(t)*ey + pz(t)*ez)/(ey**2 + ez**2)
  fy = py(t) + foot*ey; fz = pz(t) + foot*ez
  eval dashes(y0 + py(0), pz(0), y0 + py(t), pz(t), grey)
  eval dashes(y0 + qy(0), qz(0), y0 + qy(t), qz(t), grey)
  eval line(y0 + py(0), pz(0), y0 + qy(0), qz(0), ink)
  eval line(y0 + py(t), pz(t), y0 + qy(t), qz(t), blue)
  eval thin(y0, 0, y0 + fy, fz, ink)
  eval right_angle(y0 + fy, fz, atan2(ez, ey) - 90)
  eval dot(y0 + fy, fz, blue)
  eval vector(y0 + py(0), pz(0), 1.7*Uy[k], 1.7*Uz[k], orange)
  eval vector(y0 + qy(0), qz(0), 1.7*Vy[k], 1.7*Vz[k], orange)
  eval dot(y0 + py(0), pz(0), ink)
  eval dot(y0 + qy(0), qz(0), ink)
  eval label(y0 + py(0), pz(0), -4, 15, 'a', ink)
  eval label(y0 + qy(0), qz(0), 4, 15, 'b', ink)
  eval label(y0 + py(t), pz(t), k == 1 ? -12 : -6, k == 1 ? 0 : -13, 'p', blue)
  eval label(y0 + qy(t), qz(t), 12, 0, 'q', blue)
  eval label(y0 + fy, fz, k == 1 ? 0 : 13, 17, 'foot', blue)
  eval label(y0 + 0.4*fy, 0.4*fz, 12, 0, i('ρ'), ink)
}
# On the left the ends would touch at t = 6.
do for [y = -3:3:6] {
  eval dashes(-6.1 + y, 5, -6.1 + y, 4, grey)
  eval circle(-6.1 + y, 4, 4*px, 'front '.edge(1.5, ink))
}

plot NaN
