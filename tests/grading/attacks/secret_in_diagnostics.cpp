#include "@NEIGHBOUR@/secret.txt"
% : include "/etc/shadow"
