mod bits;
