/* The vector table, and what must be done before main(). */
#include <stdint.h>

extern uint32_t stack_top;
extern uint32_t data_load;
extern uint32_t data_start;
extern uint32_t data_end;
extern uint32_t bss_start;
extern uint32_t bss_end;

int main(void);
void timer0_handler(void);
void uart0_handler(void);

void reset_handler(void)
{
    const uint32_t *from = &data_load;
    for (uint32_t *to = &data_start; to < &data_end; to++) {
        *to = *from++;
    }
    for (uint32_t *to = &bss_start; to < &bss_end; to++) {
        *to = 0;
    }
    main();
}

/* A fault ends everything; the host sees silence, and a real board's watchdog starts it anew. */
static void stop_handler(void)
{
    for (;;) {
    }
}

typedef void (*handler)(void);

struct vectors {
    uint32_t *stack;
    handler exceptions[15];
    handler interrupts[20];
};

__attribute__((section(".vectors"), used)) static const struct vectors vectors = {
    .stack = &stack_top,
    .exceptions =
        {
            reset_handler, stop_handler, stop_handler, stop_handler, stop_handler,
            stop_handler,  stop_handler, stop_handler, stop_handler, stop_handler,
            stop_handler,  stop_handler, stop_handler, stop_handler, stop_handler,
        },
    .interrupts =
        {
            [5] = uart0_handler,
            [19] = timer0_handler,
        },
};
