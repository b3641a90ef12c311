// Starts Debian's Firefox over WebDriver BiDi, which Playwright cannot drive.

import { existsSync } from "node:fs";
import puppeteer from "puppeteer-core";

const PLACES = ["/usr/bin/firefox-esr", "/usr/bin/firefox"];

export async function startFirefox() {
  const executablePath = process.env.FIREFOX ?? PLACES.find(existsSync);
  if (!executablePath)
    throw new Error(`Firefox is missing (looked at ${PLACES.join(", ")}): install it, or set FIREFOX to its path`);
  const timeouts = { timeout: 180_000, protocolTimeout: 600_000 };
  return puppeteer.launch({ browser: "firefox", executablePath, headless: true, ...timeouts });
}
