import { useEffect, useRef, useState } from "react";
import "pathlight/element";
import type { PathlightPuzzle } from "pathlight/element";

export function Puzzle({ task, remember = false }: { task: string; remember?: boolean }) {
  const puzzle = useRef<PathlightPuzzle>(null);
  const [attempts, setAttempts] = useState(0);
  useEffect(() => {
    const unmounted = new AbortController();
    const { signal } = unmounted;
    puzzle.current?.addEventListener("attempt", ({ detail }) => setAttempts(detail.number), { signal });
    return () => unmounted.abort();
  }, []);
  return (
    <section>
      <pathlight-puzzle ref={puzzle} task={task} remember={remember} hide="model" />
      <p>Attempts: {attempts}</p>
    </section>
  );
}
