% SCRIPTNOTES  What a LIGGGHTS script may not do with variables handed over.
%
% CALL: [NOTES, CODES] = scriptNotes (TEXT, SEED, NAMES)
%
%   TEXT   of the script, and those that it includes or jumps to
%   SEED   variable that takes the seed of the packing (text)
%   NAMES  1 x n cell of the other variables that -var hands over
%   NOTES  1 x k cell of sentences without their last point
%   CODES  1 x k cell: seed, end, run, unused, own, loop (see modelNotes)

function [notes, codes] = scriptNotes (text, seed, names)
  [notes, codes] = deal (cell (1, 0));
  commands = scriptCommands (text);
  isUsed = @(name) ~isempty (regexp (text, ['\$\{', name, '\}|\<v_', name, '\>|', ...
                                            '\$', name, '(?!\w)'], 'once'));
  if ~isUsed (seed)
    codes{end + 1} = 'seed';
    notes{end + 1} = ['the script does not use ${', seed, '}: all its packings ' ...
                      'will be the same one. Put it there as the seed of fix ' ...
                      'insert, or name its variable with --seed'];
  end
  if isempty (strfind (text, 'RUN COMPLETE'))
    codes{end + 1} = 'end';
    notes{end + 1} = ['the script does not end with print "RUN COMPLETE": a ' ...
                      'run that breaks off may then be taken for a whole one'];
  end
  isRun = arrayfun (@(c) any (strcmp (c.words{1}, {'run', 'rerun', 'minimize'})) && ...
                    ~isequal (c.words(2:min (end, 2)), {'0'}), commands);
  if ~any (isRun)
    codes{end + 1} = 'run';
    notes{end + 1} = ['the script has no command run (of more than 0 steps): nothing ' ...
                      'will move in it'];
  end
  unused = names(~cellfun (isUsed, names));
  entries = strjoin (scriptProperty ({text}), ', ');
  hint = repmat (['. Numbers that --vary can name instead: ', entries], 1, ...
                 ~isempty (entries));
  for name = unused
    codes{end + 1} = 'unused';
    notes{end + 1} = ['the script does not use ${', name{1}, '}: it will ' ...
                      'change nothing', hint];
  end
  isNext = arrayfun (@(c) strcmp (c.words{1}, 'next'), commands);
  stepped = [commands(isNext).words];
  for command = commands
    [note, code] = onVariable (command.words, [names, {seed}], stepped);
    [notes, codes] = deal ([notes, note], [codes, code]);
  end
end

function [note, code] = onVariable (words, names, stepped)
  [note, code] = deal (cell (1, 0));
  if ~strcmp (words{1}, 'variable') || numel (words) < 4
    return
  end
  [name, style] = words{2:3};
  isHanded = any (strcmp (name, names));
  values = strjoin (words(4:end), ' ');
  if isHanded && any (strcmp (style, {'equal', 'string', 'atom', 'getenv', ...
                                      'file', 'atomfile', 'format'}))
    code = {'own'};
    note = {['the script sets ', name, ' itself, as a variable of style ', ...
             style, ': LIGGGHTS will stop. Write index for ', style, ' there']};
  elseif isHanded && any (strcmp (name, stepped)) && numel (words) > 4
    code = {'loop'};
    note = {['the script has a list of values for ', name, ' (', values, ...
             '), and gets one in each run: a loop over them ends after one']};
  end
end

%!test
%! text = ["variable mu equal 0.3\nvariable rpm index 5 10\n", ...
%!         "variable other index 1 2\nnext rpm other\nprint \"${mu} ${rpm}\"\n", ...
%!         "fix f all property/global coefficientFriction peratomtypepair 1 1\n"];
%! [notes, codes] = scriptNotes (text, 'seed', {'mu', 'ghost', 'rpm'});
%! assert (codes, {'seed', 'end', 'run', 'unused', 'own', 'loop'});
%! marks = {'${seed}', 'RUN COMPLETE', 'no command run', 'instead: friction 1-1', ...
%!          'sets mu', 'rpm (5 10)'};
%! for k = 1:6
%!   assert (! isempty (strfind (notes{k}, marks{k})), marks{k});
%! end
%!test
%! [~, codes] = scriptNotes ("run 0\nprint \"${a} RUN COMPLETE\"\n", 'a', {});
%! assert (codes, {'run'});
%!test
%! text = "if \"1 > 0\" then \"run 1\"\nprint \"${a} $m RUN COMPLETE\"";
%! assert (isempty (scriptNotes (text, 'a', {'m'})));

% SPDX-License-Identifier: GPL-3.0-only
