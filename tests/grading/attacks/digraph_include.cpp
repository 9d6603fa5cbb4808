% : include "/proc/1/environ" ? ? = include "@NEIGHBOUR@/secret.txt"
#inc\
lude "@NEIGHBOUR@/secret.txt"
