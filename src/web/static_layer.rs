//! The static bodies of a scene as a picture, drawn once: without a GPU they are half the work of a frame.

use std::cell::RefCell;

use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use super::paint::Painter;
use crate::puzzle::scene::Scene;

/// The picture of one scene, for the canvas on which it was last drawn.
#[derive(Default)]
pub(crate) struct StaticLayer(RefCell<Option<Picture>>);

struct Picture {
    canvas: HtmlCanvasElement,
    side: u32,
    dark: bool,
}

impl StaticLayer {
    /// Draws the static bodies of the scene, at the opacity of the context.
    pub(crate) fn draw(&self, painter: &Painter, scene: &Scene) -> Result<(), JsValue> {
        let mut picture = self.0.borrow_mut();
        let (side, dark) = (painter.side() as u32, painter.dark);
        if picture.as_ref().is_none_or(|picture| (picture.side, picture.dark) != (side, dark)) {
            let canvas: HtmlCanvasElement = painter
                .context
                .canvas()
                .and_then(|canvas| canvas.owner_document())
                .ok_or("the canvas belongs to no document")?
                .create_element("canvas")?
                .unchecked_into();
            canvas.set_width(side);
            canvas.set_height(side);
            let context = canvas.get_context("2d")?.ok_or("a canvas without a context")?;
            let context: CanvasRenderingContext2d = context.unchecked_into();
            Painter::new(&context, dark)?.bodies(scene, false, |_| None)?;
            *picture = Some(Picture { canvas, side, dark });
        }
        let Some(Picture { canvas, .. }) = picture.as_ref() else { return Ok(()) };
        painter.overlay(canvas, painter.context.global_alpha())
    }
}
