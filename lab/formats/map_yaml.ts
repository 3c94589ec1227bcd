// The map.yaml of ROS: a flat list of keys, which is all that map savers write.

import type { Frame } from '../engine/types';
import { fault, linesOf } from './grid';
import { usualMeaning, type Meaning } from './image';

export interface MapYaml {
  image: string;
  frame: Frame;
  meaning: Meaning;
  notes: string[];
}

const keys = ['image', 'resolution', 'origin', 'negate', 'occupied_thresh', 'free_thresh', 'mode'];

export function readMapYaml(text: string, file: string): MapYaml {
  const fields = fieldsOf(text);
  const number = (key: string, otherwise?: number): number => {
    const [value, line] = fields.get(key) ?? [];
    if (value === undefined && otherwise !== undefined) return otherwise;
    const parsed = Number(value);
    if (value === undefined || value === '' || !Number.isFinite(parsed)) throw fault(file, line ?? 0, `${key} is missing or not a number`);
    return parsed;
  };
  const image = (fields.get('image')?.[0] ?? '').replace(/^(['"])(.*)\1$/, '$2');
  if (image === '') throw fault(file, 0, "the key 'image' is missing");
  const resolution = number('resolution');
  if (resolution <= 0) throw fault(file, fields.get('resolution')![1], `resolution must be above 0, not ${resolution}`);
  const [originText, originLine] = fields.get('origin') ?? ['[0, 0, 0]', 0];
  const origin = originText.replace(/[[\]]/g, ' ').split(/[,\s]+/).filter((word) => word !== '').map(Number);
  if (origin.length < 2 || origin.some((each) => !Number.isFinite(each))) throw fault(file, originLine, 'origin must be [x, y, yaw]');
  const negateText = fields.get('negate')?.[0] ?? '0';
  if (!/^(0|1|true|false)$/i.test(negateText)) throw fault(file, fields.get('negate')![1], `negate must be 0, 1, false or true, not '${negateText}'`);
  const mode = (fields.get('mode')?.[0] ?? 'trinary').replace(/['"]/g, '');
  if (mode !== 'trinary' && mode !== 'scale' && mode !== 'raw') throw fault(file, fields.get('mode')![1], `mode must be trinary, scale or raw, not '${mode}'`);
  const occupied = number('occupied_thresh', usualMeaning.occupied);
  const free = number('free_thresh', usualMeaning.free);
  if (free >= occupied) throw fault(file, 0, `free_thresh ${free} must be below occupied_thresh ${occupied}`);
  return {
    image,
    frame: { resolution, originX: origin[0]!, originY: origin[1]!, originYaw: origin[2] ?? 0, yUp: true, metric: true },
    meaning: { mode, negate: /^(1|true)$/i.test(negateText), occupied, free },
    notes: [...fields.keys()].filter((key) => !keys.includes(key)).map((key) => `unknown key '${key}' in the map.yaml is ignored`),
  };
}

/** Values by key, with their lines. A list may go on over several lines. */
function fieldsOf(text: string): Map<string, [string, number]> {
  const fields = new Map<string, [string, number]>();
  let key = '';
  linesOf(text).forEach((line, i) => {
    const plain = line.replace(/(^|\s)#.*$/, '').trimEnd();
    const match = /^([A-Za-z_]\w*)\s*:\s*(.*)$/.exec(plain);
    if (match) {
      key = match[1]!;
      fields.set(key, [match[2]!, i + 1]);
    } else if (/^\s/.test(plain) && fields.has(key)) {
      const [value, first] = fields.get(key)!;
      fields.set(key, [`${value} ${plain.trim().replace(/^-\s+/, '')}`.trim(), first]);
    }
  });
  return fields;
}

/** The text of a map.yaml beside an image. */
export function writeMapYaml(image: string, frame: Frame): string {
  return `image: ${image}\nmode: trinary\nresolution: ${frame.resolution}\norigin: [${frame.originX}, ${frame.originY}, ${frame.originYaw}]\n` +
    `negate: 0\noccupied_thresh: ${usualMeaning.occupied}\nfree_thresh: ${usualMeaning.free}\n`;
}
