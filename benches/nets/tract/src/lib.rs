//! Runs the nets of an ONNX file with tract. The wasm build has plain exports and no bindings: JavaScript copies values
//! into and out of memory.

use std::sync::Arc;

use tract_onnx::prelude::*;

/// Values in an image.
pub const IMAGE: usize = 5 * 64 * 64;

pub struct Nets(Arc<TypedRunnableModel>);

impl Nets {
    /// Loads the nets from the bytes of the ONNX file.
    pub fn load(mut onnx: &[u8]) -> TractResult<Nets> {
        let model = tract_onnx::onnx().model_for_read(&mut onnx)?.into_optimized()?;
        Ok(Nets(model.into_runnable()?))
    }

    /// Returns the maps of a scene, concatenated, from its images, also concatenated.
    pub fn imagine(&self, images: &[f32]) -> TractResult<Vec<f32>> {
        let mut inputs = tvec!();
        for image in images.chunks(IMAGE) {
            inputs.push(Tensor::from_shape(&[1, 5, 64, 64], image)?.into());
        }
        let mut maps = Vec::new();
        for map in self.0.run(inputs)? {
            maps.extend_from_slice(map.to_plain_array_view::<f32>()?.as_slice().expect("contiguous"));
        }
        Ok(maps)
    }
}

#[cfg(target_arch = "wasm32")]
mod exports {
    use super::{IMAGE, Nets};

    /// Allocates `bytes` bytes, which are never freed.
    #[unsafe(no_mangle)]
    pub extern "C" fn room(bytes: usize) -> *mut u8 {
        Box::leak(vec![0_u128; bytes.div_ceil(16)].into_boxed_slice()).as_mut_ptr().cast()
    }

    /// Loads the nets from an ONNX file.
    ///
    /// # Safety
    /// `onnx` points to `length` bytes allocated by `room`.
    #[unsafe(no_mangle)]
    pub unsafe extern "C" fn load(onnx: *const u8, length: usize) -> *const Nets {
        let onnx = unsafe { std::slice::from_raw_parts(onnx, length) };
        Box::leak(Box::new(Nets::load(onnx).expect("tract reads the file")))
    }

    /// Writes the maps of a scene to `maps`.
    ///
    /// # Safety
    /// `images` points to `count` images allocated by `room`, and `maps` to room for all values of all maps.
    #[unsafe(no_mangle)]
    pub unsafe extern "C" fn imagine(nets: &Nets, images: *const f32, count: usize, maps: *mut f32) {
        let images = unsafe { std::slice::from_raw_parts(images, count * IMAGE) };
        let found = nets.imagine(images).expect("the shapes are right");
        unsafe { std::slice::from_raw_parts_mut(maps, found.len()) }.copy_from_slice(&found);
    }
}
