#define skew stolen_skew
#include "@ROOT@/solutions/1_rigid_body_kinematics/rigid_body_kinematics.cpp"
#undef skew
