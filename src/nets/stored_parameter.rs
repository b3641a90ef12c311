//! Storage of a parameter in a weights file: in half precision, or in one byte per value if all values are multiples of
//! one step, as produced by `rounding`. Both forms hold exactly the same numbers.
//!
//! `NAME` holds the multiples, of type I8, and `NAME.step` the step, F32 `[1]`. A multiple that needs more than a byte
//! is 0 there; `NAME.outliers`, I16 `[count]`, holds those multiples, and `NAME.outliers.at`, U32 `[count]`, their
//! indices.

use half::f16;
use safetensors::View;
use safetensors::tensor::{Dtype, SafeTensors, TensorView};
use std::borrow::Cow;

use super::weights::WeightsError;

/// A tensor of a weights file.
pub(crate) struct Stored {
    dtype: Dtype,
    shape: Vec<usize>,
    bytes: Vec<u8>,
}

impl View for Stored {
    fn dtype(&self) -> Dtype {
        self.dtype
    }

    fn shape(&self) -> &[usize] {
        &self.shape
    }

    fn data(&self) -> Cow<'_, [u8]> {
        (&self.bytes).into()
    }

    fn data_len(&self) -> usize {
        self.bytes.len()
    }
}

/// Returns the tensors that store a parameter, by name.
pub(crate) fn stored(name: &str, shape: Vec<usize>, values: &[f16]) -> Vec<(String, Stored)> {
    match multiples(values) {
        Some(Multiples { step, small, outliers }) => {
            let mut tensors = vec![
                (name.to_string(), Stored { dtype: Dtype::I8, shape, bytes: small.iter().map(|&k| k as u8).collect() }),
                (step_of(name), Stored { dtype: Dtype::F32, shape: vec![1], bytes: step.to_le_bytes().into() }),
            ];
            if !outliers.is_empty() {
                let shape = vec![outliers.len()];
                let at = outliers.iter().flat_map(|(index, _)| index.to_le_bytes()).collect();
                let multiples = outliers.iter().flat_map(|(_, multiple)| multiple.to_le_bytes()).collect();
                tensors.extend([
                    (outliers_of(name), Stored { dtype: Dtype::I16, shape: shape.clone(), bytes: multiples }),
                    (indices_of(name), Stored { dtype: Dtype::U32, shape, bytes: at }),
                ]);
            }
            tensors
        }
        None => {
            let bytes = values.iter().flat_map(|value| value.to_le_bytes()).collect();
            vec![(name.to_string(), Stored { dtype: Dtype::F16, shape, bytes })]
        }
    }
}

/// Reads the parameter of this name and shape. Returns its values and the number of tensors that store it.
pub(crate) fn read(file: &SafeTensors, name: &str, shape: &[usize]) -> Result<(Vec<f32>, usize), WeightsError> {
    let view = file.tensor(name).map_err(|_| WeightsError::Missing(name.to_string()))?;
    let (values, tensors) = match view.dtype() {
        Dtype::I8 => {
            let bytes = data(&view, name, shape, Dtype::I8)?;
            read_multiples(file, name, bytes)?
        }
        dtype if dtype != Dtype::F16 && view.shape() == shape => {
            return Err(WeightsError::OtherType { name: name.to_string(), dtype });
        }
        _ => {
            let halves = data(&view, name, shape, Dtype::F16)?.as_chunks().0.iter();
            (halves.map(|&half| f16::from_le_bytes(half).to_f32()).collect(), 1)
        }
    };
    if values.iter().all(|value| value.is_finite()) {
        Ok((values, tensors))
    } else {
        Err(WeightsError::NotFinite(name.to_string()))
    }
}

fn read_multiples(file: &SafeTensors, name: &str, bytes: &[u8]) -> Result<(Vec<f32>, usize), WeightsError> {
    let find = |name: &str| file.tensor(name).map_err(|_| WeightsError::Missing(name.to_string()));
    let name_of_step = step_of(name);
    let step = data(&find(&name_of_step)?, &name_of_step, &[1], Dtype::F32)?.try_into().expect("four bytes");
    let step = f32::from_le_bytes(step);
    let mut values: Vec<f32> = bytes.iter().map(|&byte| f32::from(byte as i8) * step).collect();
    let (name, name_of_indices) = (outliers_of(name), indices_of(name));
    let Ok(outliers) = file.tensor(&name) else { return Ok((values, 2)) };
    let indices = find(&name_of_indices)?;
    let multiples = data(&outliers, &name, &[outliers.data().len() / 2], Dtype::I16)?.as_chunks().0.iter();
    let indices = data(&indices, &name_of_indices, outliers.shape(), Dtype::U32)?.as_chunks().0.iter();
    for (&index, &multiple) in indices.zip(multiples) {
        let index = u32::from_le_bytes(index);
        let Some(value) = values.get_mut(index as usize) else {
            return Err(WeightsError::Outlier { name: name_of_indices, index });
        };
        *value = f32::from(i16::from_le_bytes(multiple)) * step;
    }
    Ok((values, 4))
}

/// Returns the bytes of a tensor, which must have this shape and type.
fn data<'a>(view: &TensorView<'a>, name: &str, shape: &[usize], dtype: Dtype) -> Result<&'a [u8], WeightsError> {
    if view.dtype() == dtype && view.shape() == shape {
        return Ok(view.data());
    }
    Err(WeightsError::ShapeMismatch {
        name: name.to_string(),
        found: (view.shape().to_vec(), view.dtype()),
        expected: (shape.to_vec(), dtype),
    })
}

fn step_of(name: &str) -> String {
    format!("{name}.step")
}

fn outliers_of(name: &str) -> String {
    format!("{name}.outliers")
}

fn indices_of(name: &str) -> String {
    format!("{name}.outliers.at")
}

/// Values as multiples of a step.
struct Multiples {
    step: f32,
    small: Vec<i8>,
    /// Index and multiple of each value that needs more than a byte.
    outliers: Vec<(u32, i16)>,
}

/// Returns values as multiples of the largest power of two that divides them all; `None` if they need less space in
/// half precision, if a multiple does not fit into two bytes, or if a value is negative zero, which is not a multiple.
fn multiples(values: &[f16]) -> Option<Multiples> {
    /// Header space for the names and shapes of three more tensors, bytes.
    const HEADER: usize = 300;
    let exponents = values.iter().filter(|value| value.to_f32() != 0.0).map(|value| lowest_exponent(value.to_f32()));
    let step = libm::ldexpf(1.0, exponents.min()?);
    let mut outliers = Vec::new();
    let mut small = Vec::with_capacity(values.len());
    for (index, value) in values.iter().enumerate() {
        if value.to_bits() == f16::NEG_ZERO.to_bits() {
            return None;
        }
        // Exact: half precision spans at most 40 binary digits, of which a number uses eleven.
        let multiple = value.to_f32() / step;
        if multiple.abs() <= f32::from(i8::MAX) {
            small.push(multiple as i8);
            continue;
        }
        if multiple.abs() > f32::from(i16::MAX) {
            return None;
        }
        small.push(0);
        outliers.push((u32::try_from(index).ok()?, multiple as i16));
    }
    let bytes = HEADER + small.len() + outliers.len() * (size_of::<u32>() + size_of::<i16>());
    (bytes < size_of_val(values)).then_some(Multiples { step, small, outliers })
}

/// Returns the exponent of the lowest set bit of a normal number.
fn lowest_exponent(value: f32) -> i32 {
    let bits = value.to_bits();
    let significand = bits & 0x7f_ffff | 0x80_0000;
    (bits >> 23 & 0xff) as i32 - 150 + significand.trailing_zeros() as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn halves(values: impl IntoIterator<Item = f32>) -> Vec<f16> {
        values.into_iter().map(f16::from_f32).collect()
    }

    fn file(values: &[f16]) -> Vec<u8> {
        safetensors::serialize(stored("weight", vec![values.len()], values), None).expect("a file")
    }

    fn assert_survives(values: &[f16], tensors: usize) {
        let bytes = file(values);
        let file = SafeTensors::deserialize(&bytes).expect("our own file");
        let (found, count) = read(&file, "weight", &[values.len()]).expect("our own tensor");
        assert_eq!((count, file.len()), (tensors, tensors));
        let bits = |value: f32| value.to_bits();
        assert!(found.iter().map(|&value| bits(value)).eq(values.iter().map(|value| bits(value.to_f32()))));
    }

    #[test]
    fn multiples_of_a_step_take_a_byte_each_and_survive_bit_for_bit() {
        for step in [1.0 / 4096.0, 1.0, f32::from(f16::MIN_POSITIVE_SUBNORMAL)] {
            let small = (0..1000).map(|index| (index % 255 - 127) as f32 * step);
            assert_survives(&halves(small.clone()), 2);
            let with_outliers = halves(small.chain([128.0 * step, -1000.0 * step, 300.0 * step]));
            assert_survives(&with_outliers, 4);
            assert!(file(&with_outliers).len() < 1500);
        }
    }

    #[test]
    fn other_values_stay_in_half_precision() {
        let spread = |index: i32| 1.3_f32.powi(index % 40 - 20);
        assert_survives(&halves((0..1000).map(spread)), 1);
        assert_survives(&halves([0.0; 1000]), 1);
        assert_survives(&halves((0..1000).map(|index| if index == 7 { -0.0 } else { 1.0 })), 1);
        assert_survives(&halves([1.0, 2.0]), 1);
        let extremes = [f16::MAX, f16::MIN_POSITIVE_SUBNORMAL];
        assert_survives(&extremes.repeat(500), 1);
    }

    #[test]
    fn weights_of_other_types_are_refused_with_the_remedy() {
        for (dtype, size) in [(Dtype::BF16, 2), (Dtype::F32, 4), (Dtype::F64, 8), (Dtype::I16, 2), (Dtype::U8, 1)] {
            let tensor = |count: usize| Stored { dtype, shape: vec![count], bytes: vec![0; count * size] };
            let bytes = safetensors::serialize([("weight", tensor(9))], None).expect("a file");
            let file = SafeTensors::deserialize(&bytes).expect("a safetensors file");
            let refused = read(&file, "weight", &[9]).expect_err("another type").to_string();
            assert!(refused.contains(&format!("type {dtype}")) && refused.ends_with("as F16"), "{refused}");
            let refused = read(&file, "weight", &[8]).expect_err("another shape").to_string();
            assert!(refused.contains("belong to other nets"), "{refused}");
        }
    }

    #[test]
    fn damaged_files_are_refused() {
        let shape = vec![1000];
        let values = halves((0..1000).map(|index| if index == 3 { 200.0 } else { (index % 100) as f32 }));
        type Damage<'a> = &'a dyn Fn(&mut Vec<(String, Stored)>);
        let refusal = |damage: Damage| {
            let mut tensors = stored("weight", shape.clone(), &values);
            damage(&mut tensors);
            let bytes = safetensors::serialize(tensors, None).expect("a file");
            let file = SafeTensors::deserialize(&bytes).expect("a safetensors file");
            read(&file, "weight", &shape).expect_err("damaged").to_string()
        };
        let says = |damage: Damage, words: &str| {
            let sentence = refusal(damage);
            assert!(sentence.contains(words), "{sentence}");
        };
        says(&|tensors| drop(tensors.remove(1)), "lack `weight.step`");
        says(&|tensors| tensors[1].1.bytes = f32::NAN.to_le_bytes().into(), "not finite");
        says(&|tensors| tensors[1].1.dtype = Dtype::I32, "`weight.step` has shape [1] and type I32");
        says(&|tensors| drop(tensors.remove(3)), "lack `weight.outliers.at`");
        says(&|tensors| tensors[2].1.shape = vec![1, 1], "`weight.outliers` has shape [1, 1]");
        for index in [1000, u32::MAX] {
            says(&|tensors| tensors[3].1.bytes = index.to_le_bytes().into(), "`weight.outliers.at` names the value");
        }
    }
}
