/* The macros of the stubs that write_stubs writes. WEND_STUB name, number: jumps to the function that has been found;
   the first time, wend_load_function(number) finds it, with all registers of arguments as they were. */
  .text

  .macro WEND_STUB name, number
  .globl \name
  .hidden \name
  .type \name, @function
\name:
  endbr64
  mov wend_stub_targets + 8 * \number(%rip), %r11
  test %r11, %r11
  jz 1f
  jmp *%r11
1:
  mov $\number, %r11d
  jmp wend_find_function
  .size \name, . - \name
  .endm

  .macro WEND_STUB_NAME library, function
  .asciz "\library"
  .asciz "\function"
  .endm

wend_find_function:
  push %rdi
  push %rsi
  push %rdx
  push %rcx
  push %r8
  push %r9
  push %rax
  sub $144, %rsp
  movups %xmm0, (%rsp)
  movups %xmm1, 16(%rsp)
  movups %xmm2, 32(%rsp)
  movups %xmm3, 48(%rsp)
  movups %xmm4, 64(%rsp)
  movups %xmm5, 80(%rsp)
  movups %xmm6, 96(%rsp)
  movups %xmm7, 112(%rsp)
  mov %r11, 128(%rsp)
  mov %r11d, %edi
  call wend_load_function
  mov 128(%rsp), %r11
  lea wend_stub_targets(%rip), %rdi
  mov %rax, (%rdi, %r11, 8)
  mov %rax, %r11
  movups (%rsp), %xmm0
  movups 16(%rsp), %xmm1
  movups 32(%rsp), %xmm2
  movups 48(%rsp), %xmm3
  movups 64(%rsp), %xmm4
  movups 80(%rsp), %xmm5
  movups 96(%rsp), %xmm6
  movups 112(%rsp), %xmm7
  add $144, %rsp
  pop %rax
  pop %r9
  pop %r8
  pop %rcx
  pop %rdx
  pop %rsi
  pop %rdi
  jmp *%r11
