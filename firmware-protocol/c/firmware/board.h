/* What one board is: every number may be given to the compiler, as in -DBOARD=3 -DFIRST_KEY=33. */
#ifndef BOARD_H
#define BOARD_H

#ifndef BOARD
#define BOARD 0
#endif
#ifndef N_KEYS
#define N_KEYS 11
#endif
#ifndef FIRST_KEY
#define FIRST_KEY (11 * BOARD)
#endif
#ifndef MAX_FORCE_MN
#define MAX_FORCE_MN 30000
#endif

/* The law and the plant run every so often [us]. */
#define STEP_US 100
/* Steps that are made up for in one go; what is older is given up. */
#define MOST_STEPS 500
#define LAW_HZ (1000000 / STEP_US)

#define MAX_SAMPLE_HZ 2000
#define MAX_FORCE_HZ 2000
/* What a count of the encoder means [nm]. */
#define QUANTUM_NM 1000

#define FIRMWARE_MAJOR 2
#define FIRMWARE_MINOR 0

#if BOARD < 0 || 14 < BOARD || N_KEYS < 1 || 12 < N_KEYS || FIRST_KEY < 0 || 88 < FIRST_KEY + N_KEYS
#error "a board is 0 to 14 and has 1 to 12 keys of the 88"
#endif

#endif
