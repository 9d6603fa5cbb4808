# The bank of mistakes: each is a misconception that students have, as a small edit of the reference.
# add_mutant(<lab> <mistake> <step> <find> <replace> <words its message must hold>)
set(lab continuous_particle_cylinder)
