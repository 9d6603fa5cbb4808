# Draws nearest.svg: the nearest points of two edges, and a triangle with the axis inside.
load 'labs/sketch_style.gp'
set output 'labs/3_discrete_particle_cylinder/sketches/nearest.svg'
eval view(0, 0, 40)

# On the left, edges from a to b; f of the nearest point as in (5).
y0 = -4.15; z0 = -0.4
array Ay = [-2.3, 0.9]
array Az = [ 2.0, -2.0]
array By = [ 2.0, 2.5]
array Bz = [ 2.9, -2.8]
eval dashed_ring(y0, z0, 1.5, grey)
eval thin(y0, z0, y0 - 1.5*cos(35), z0 - 1.5*sin(35), grey)
eval label(y0 - 0.75*cos(35), z0 - 0.75*sin(35), -5, 9, i('ρ'), ink)
eval dot(y0, z0, ink)
do for [k = 1:2] {
  ay = y0 + Ay[k]; az = z0 + Az[k]; ey = By[k] - Ay[k]; ez = Bz[k] - Az[k]
  f = -(Ay[k]*ey + Az[k]*ez)/(ey**2 + ez**2)
  f = f < 0 ? 0 : f > 1 ? 1 : f
  eval line(ay, az, ay + ey, az + ez, ink)
  eval dashes(y0, z0, ay + f*ey, az + f*ez, blue)
  eval dot(ay, az, ink)
  eval dot(ay + ey, az + ez, ink)
  eval dot(ay + f*ey, az + f*ez, blue)
  eval label(ay, az, k == 1 ? -12 : -6, k == 1 ? 2 : -14, 'a', ink)
  eval label(ay + ey, az + ez, 13, 2, 'b', ink)
  if (k == 1) { eval right_angle(ay + f*ey, az + f*ez, atan2(ez, ey) - 90) }
  if (k == 1) { eval label(ay + f*ey, az + f*ez, 0, 17, 'a + '.i('f').' e', blue) }
  if (k == 2) { eval label(ay, az, 28, 8, i('f').' = 0', blue) }
}

# On the right, the triangle of "Try it", cut in three by the axis.
y0 = 2.4; z0 = 0
array Cy = [4, -2, -2]
array Cz = [0, 3, -3]
name = 'a b c'
tint = pale_blue.' '.pale_orange.' '.pale_green
do for [k = 1:3] {
  j = k%3 + 1
  ky = y0 + Cy[k]; kz = z0 + Cz[k]; jy = y0 + Cy[j]; jz = z0 + Cz[j]
  set object polygon from y0,z0 to ky,kz to jy,jz to y0,z0 \
    behind fs solid noborder fc rgb word(tint, k)
  eval line(ky, kz, jy, jz, ink)
  eval thin(y0, z0, ky, kz, ink)
  eval dot(ky, kz, ink)
  eval label((y0 + ky + jy)/3, (z0 + kz + jz)/3, 0, 0, word(name, k).' × '.word(name, j), ink)
  eval label(ky, kz, 14*sgn(Cy[k]), 0, word(name, k), ink)
}
eval dashed_ring(y0, z0, 0.5, grey)
eval dot(y0, z0, ink)

plot NaN
