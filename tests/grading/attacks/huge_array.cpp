char huge[6000000000UL] = {1};
