/* SysTick counts down freely; what it counted is added up. So no interrupt has to come in time
 * for the clock to be right. A timer of its own wakes the processor.
 */
#include "clock.h"

/* The processor after reset: 12.5 MHz in QEMU, where the real one has 12 MHz. */
#ifndef CPU_HZ
#define CPU_HZ 12500000u
#endif

#define SYSTICK_MASK 0xFFFFFFu
#define SYSTICK_CTRL (*(volatile uint32_t *)0xE000E010u)
#define SYSTICK_LOAD (*(volatile uint32_t *)0xE000E014u)
#define SYSTICK_VAL (*(volatile uint32_t *)0xE000E018u)
#define RCGC1 (*(volatile uint32_t *)0x400FE104u)
#define TIMER0(at) (*(volatile uint32_t *)(0x40030000u + (at)))
#define NVIC_ENABLE (*(volatile uint32_t *)0xE000E100u)
#define TIMER0_IRQ 19u

static volatile bool woke;
static uint32_t last_count;
static uint32_t microseconds;
/* Counts that are no whole microsecond yet, times a million. */
static uint64_t remainder;

void clock_begin(void)
{
    SYSTICK_LOAD = SYSTICK_MASK;
    SYSTICK_VAL = 0;
    /* Enabled, from the processor's clock, without interrupts. */
    SYSTICK_CTRL = 5;
    last_count = SYSTICK_VAL;
    RCGC1 |= 1u << 16;
    TIMER0(0x0C) = 0;
    /* 32 bits, once, its end interrupts. */
    TIMER0(0x00) = 0;
    TIMER0(0x04) = 1;
    TIMER0(0x18) = 1;
    NVIC_ENABLE = 1u << TIMER0_IRQ;
}

void clock_wake_in(uint32_t us)
{
    TIMER0(0x0C) = 0;
    woke = false;
    TIMER0(0x28) = (uint32_t)((uint64_t)CPU_HZ * (us + 1u) / 1000000u);
    TIMER0(0x0C) = 1;
}

void timer0_handler(void)
{
    TIMER0(0x24) = 1;
    woke = true;
}

bool clock_woke(void)
{
    return woke;
}

uint32_t clock_us(void)
{
    uint32_t count = SYSTICK_VAL;
    remainder += (uint64_t)((last_count - count) & SYSTICK_MASK) * 1000000u;
    last_count = count;
    microseconds += (uint32_t)(remainder / CPU_HZ);
    remainder %= CPU_HZ;
    return microseconds;
}
