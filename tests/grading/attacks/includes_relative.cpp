#include "../../solutions/1_rigid_body_kinematics/rigid_body_kinematics.cpp"
