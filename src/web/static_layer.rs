//! The static bodies of a scene as a picture, drawn once: without a GPU they are half the work of a frame.

use std::cell::RefCell;

use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use super::error::{Code, error};
use super::paint::Painter;
use crate::puzzle::scene::Scene;

/// The picture of one scene: side, theme, canvas and its context.
#[derive(Default)]
pub(crate) struct StaticLayer(RefCell<Option<(u32, bool, HtmlCanvasElement, CanvasRenderingContext2d)>>);

impl StaticLayer {
    /// Draws the static bodies of the scene, at the opacity of the context.
    pub(crate) fn draw(&self, painter: &Painter, scene: &Scene) -> Result<(), JsValue> {
        let (side, dark) = (painter.side() as u32, painter.dark);
        // An empty canvas cannot be drawn.
        if side == 0 {
            return Ok(());
        }
        // A context that the browser has restored has lost its settings, and with them what was painted.
        let is_intact = |context: &CanvasRenderingContext2d| context.line_join() == painter.context.line_join();
        let kept = self.0.take().filter(|(of, theme, _, context)| (*of, *theme) == (side, dark) && is_intact(context));
        let (canvas, context) = match kept {
            Some((.., canvas, context)) => (canvas, context),
            None => drawn(painter, scene)?,
        };
        painter.overlay(&canvas, painter.context.global_alpha())?;
        self.0.replace(Some((side, dark, canvas, context)));
        Ok(())
    }
}

fn drawn(painter: &Painter, scene: &Scene) -> Result<(HtmlCanvasElement, CanvasRenderingContext2d), JsValue> {
    let missing = || error(Code::BadData, "the browser gives no second canvas");
    let document = painter.context.canvas().and_then(|canvas| canvas.owner_document()).ok_or_else(missing)?;
    let canvas: HtmlCanvasElement = document.create_element("canvas")?.unchecked_into();
    canvas.set_width(painter.side() as u32);
    canvas.set_height(painter.side() as u32);
    let context: CanvasRenderingContext2d = canvas.get_context("2d")?.ok_or_else(missing)?.unchecked_into();
    Painter::new(&context, painter.dark)?.bodies(scene, false, |_| None)?;
    Ok((canvas, context))
}
