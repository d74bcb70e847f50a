// SPDX-License-Identifier: MIT
// task_types.mjs SCHEMA: prints the TypeScript types of task files, from their JSON schema.
import { readFileSync } from 'node:fs';

const kWidth = 110; // of a comment's line
const kTuples = new Map([[3, 'Vec3'], [4, 'Quat']]);

/** "GoalAxis" of "goal_axis". */
const typeName = (definition) => definition.replaceAll(/(?:^|_)(.)/g, (_, letter) => letter.toUpperCase());

const literal = (value) => (typeof value === 'string' ? `'${value}'` : String(value));

function comment(text, indent) {
  if (!text) return '';
  const lines = [''];
  for (const word of text.split(' ')) {
    if (lines.at(-1).length + word.length > kWidth) lines.push('');
    lines.push(`${lines.pop()} ${word}`);
  }
  return `${indent}/**${lines.join(`\n${indent} *`)} */\n`;
}

class Types {
  constructor(schema) {
    this.schema = schema;
  }

  of(rule, indent) {
    if (rule.$ref) return this.reference(rule.$ref);
    if ('const' in rule) return literal(rule.const);
    if (rule.enum) return rule.enum.map(literal).join(' | ');
    if (rule.anyOf) return rule.anyOf.map((choice) => this.of(choice, indent)).join(' | ');
    if (rule.type === 'array') return this.list(rule, indent);
    if (rule.type === 'integer') return 'number';
    if (rule.type !== 'object') return rule.type;
    return rule.properties ? this.members(rule, indent) : `Record<string, ${this.of(rule.additionalProperties, indent)}>`;
  }

  /** Structs have types by their names; numbers and lists of them are written out. */
  reference(path) {
    const name = path.replace('#/$defs/', '');
    const rule = this.schema.$defs[name];
    return rule.type === 'object' ? typeName(name) : this.of(rule, '');
  }

  list(rule, indent) {
    const item = this.of(rule.items, indent);
    if (rule.minItems === undefined || rule.minItems !== rule.maxItems) return item.includes(' ') ? `(${item})[]` : `${item}[]`;
    const tuple = item === 'number' ? kTuples.get(rule.minItems) : undefined;
    return tuple ?? `[${Array.from({ length: rule.minItems }, () => item).join(', ')}]`;
  }

  members(rule, indent) {
    const inner = `${indent}  `;
    const lines = Object.entries(rule.properties).map(([key, member]) => {
      const absent = rule.required?.includes(key) ? '' : '?';
      return `${comment(member.description, inner)}${inner}${key}${absent}: ${this.of(member, inner)};\n`;
    });
    return `{\n${lines.join('')}${indent}}`;
  }

  struct(name, rule) {
    return `${comment(rule.description, '')}export interface ${name} ${this.members(rule, '')}\n`;
  }

  all() {
    const structs = Object.entries(this.schema.$defs).filter(([, rule]) => rule.type === 'object');
    return [
      '// SPDX-License-Identifier: MIT\n'
        + '// Task files, as docs/task.schema.json has them: `scripts/make_schema` writes this file.\n',
      'export type Vec3 = [number, number, number];\nexport type Quat = [number, number, number, number];\n',
      ...structs.map(([name, rule]) => this.struct(typeName(name), rule)),
      this.struct('Task', this.schema),
    ].join('\n');
  }
}

process.stdout.write(new Types(JSON.parse(readFileSync(process.argv[2], 'utf8'))).all());
