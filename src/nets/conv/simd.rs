//! Vector registers through pulp, which selects the processor's instructions at run time: AVX-512, AVX2 or SSE4.1 on
//! x86-64, and simd128 in wasm.
//!
//! When a net is applied, no kernel fuses multiplications with additions, and the order of each sum does not depend on
//! the number of lanes. All instruction sets, including wasm's, therefore compute the same maps, bit for bit. Training
//! does fuse, which is faster, and so does gemm, which multiplies only batches: trained weights depend on the
//! processor.

use pulp::{Simd, WithSimd};

/// Runs `work` on the widest registers of the processor. If it has several widths, uses at most `lanes` lanes.
#[cfg_attr(not(target_arch = "x86_64"), expect(unused_variables, reason = "there is one width"))]
pub(crate) fn vectorize<W: WithSimd>(lanes: usize, work: W) -> W::Output {
    #[cfg(target_arch = "x86_64")]
    {
        if let Some(simd) = pulp::x86::V4::try_new()
            && lanes >= 16
        {
            return Simd::vectorize(simd, work);
        }
        if let Some(simd) = pulp::x86::V3::try_new()
            && lanes >= 8
        {
            return Simd::vectorize(simd, work);
        }
        if let Some(simd) = pulp::x86::V2::try_new() {
            return Simd::vectorize(simd, work);
        }
    }
    baseline(work)
}

/// Returns the largest number of lanes, a power of two, that divides the length of a row.
pub(crate) fn lanes_that_divide(row: usize) -> usize {
    1 << row.trailing_zeros()
}

/// Runs `work` with the instructions that every processor of the architecture has.
fn baseline<W: WithSimd>(work: W) -> W::Output {
    // `.cargo/config.toml` enables it here. A build of the published crate, or one that sets RUSTFLAGS, may lack it.
    #[cfg(target_arch = "wasm32")]
    if let Some(simd) = pulp::wasm::Simd128::try_new() {
        return Simd::vectorize(simd, work);
    }
    #[cfg(target_arch = "aarch64")]
    if let Some(simd) = pulp::aarch64::Neon::try_new() {
        return Simd::vectorize(simd, work);
    }
    Simd::vectorize(pulp::Scalar128b, work)
}

/// Loads a register of values, starting at `at`.
#[inline(always)]
pub(crate) fn load<S: Simd>(values: &[f32], at: usize) -> S::f32s {
    S::as_simd_f32s(&values[at..at + S::F32_LANES]).0[0]
}

/// Adds the products of a weight and some registers to sums. Each product and each sum is rounded, unless they are
/// `FUSED`, which rounds both at once where the processor can.
#[inline(always)]
pub(crate) fn multiply_add<S: Simd, const FUSED: bool, const REGISTERS: usize>(
    simd: S,
    sums: &mut [S::f32s; REGISTERS],
    weight: f32,
    x: [S::f32s; REGISTERS],
) {
    let weight = simd.splat_f32s(weight);
    for (sum, x) in sums.iter_mut().zip(x) {
        *sum = if FUSED { simd.mul_add_e_f32s(weight, x, *sum) } else { simd.add_f32s(*sum, simd.mul_f32s(weight, x)) };
    }
}
