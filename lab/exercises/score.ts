// The score of an exercise, and what was said last.

export interface Score {
  right: number;
  asked: number;
  said: string;
}

export const noScore: Score = { right: 0, asked: 0, said: '' };

/** The score after one more answer. */
export function scored(score: Score, right: boolean, said: string): Score {
  return { right: score.right + (right ? 1 : 0), asked: score.asked + 1, said };
}
