% SCRIPTPROPERTY  Entries of fix property/global in LIGGGHTS scripts.
%
% CALL: [TEXTS, VARIABLE, WAS] = scriptProperty (TEXTS, NAME)
%       LIST = scriptProperty (TEXTS)
%
%   TEXTS     1 x s cell of scripts; back with ${VARIABLE} in place of the entry,
%             of a pair in both orders
%   NAME      text: the property as LIGGGHTS names it, or friction,
%             rollingFriction, restitution, cohesion; behind a blank the type of
%             the grains (youngsModulus 1) or both of a pair (friction 1-2); none
%             where the property has one value
%   VARIABLE  name of the variable (text): friction_1_2
%   WAS       1 x w cell, what stood there
%   LIST      1 x n cell of texts: NAME of each entry that is a number
%
% Errors: DEcalioc:scriptProperty:unknownName

function [texts, variable, was] = scriptProperty (texts, name)
  found = cellfun (@entriesOf, texts, 'UniformOutput', false);
  % in Octave an empty struct loses its fields in brackets
  all = [found{~cellfun(@isempty, found)}];
  if nargin < 2
    texts = cell (1, 0);
    if ~isempty (all)
      numbers = all(isfinite (str2double ({all.text})));
      texts = unique (arrayfun (@label, numbers, 'UniformOutput', false));
    end
    return
  end
  parts = regexp (name, '^(\w+)(?:\s+(\d+)(?:\s*-\s*(\d+))?)?$', 'tokens', ...
                  'once');
  parts = [parts(:)', {'', '', ''}];
  types = sort (str2double (parts(2:3)));
  types = types(isfinite (types));
  full = longName (parts{1});
  isMeant = @(e) strcmpi (e.name, full) && isequal (e.types, types);
  mine = all(logical (arrayfun (isMeant, all)));
  if isempty (mine)
    known = unique (arrayfun (@label, all, 'UniformOutput', false));
    error ('DEcalioc:scriptProperty:unknownName', ...
           ['%s must name an entry of a fix property/global of the script ' ...
            '(as friction 1-2, or youngsModulus 1), got one that it does ' ...
            'not have. It has: %s.'], name, strjoin (known, ', '));
  end
  was = unique ({mine.text});
  variable = strjoin ([parts(1), arrayfun(@(t) sprintf ('%d', t), types, ...
                                          'UniformOutput', false)], '_');
  for s = 1:numel (texts)
    for e = fliplr (found{s}(arrayfun (isMeant, found{s})))
      texts{s} = [texts{s}(1:e.place - 1), '${', variable, '}', ...
                  texts{s}(e.place + numel (e.text):end)];
    end
  end
end

function name = longName (name)
  short = {'friction', 'rollingFriction', 'restitution', 'cohesion'};
  long = {'coefficientFriction', 'coefficientRollingFriction', ...
          'coefficientRestitution', 'cohesionEnergyDensity'};
  at = strcmpi (name, short);
  if any (at)
    name = long{at};
  end
end

function text = label (entry)
  text = regexprep (entry.name, '^coefficient', '');
  if ~strcmp (text, entry.name)
    text(1) = tolower (text(1));
  end
  numbers = arrayfun (@(t) sprintf ('%d', t), entry.types, ...
                      'UniformOutput', false);
  text = strtrim ([text, ' ', strjoin(numbers, '-')]);
end

% Of one script: name, types, text and place of each entry; remarks are blanked
% so that places stay.
function entries = entriesOf (text)
  [first, last] = regexp (text, '#[^\n]*', 'start', 'end');
  for k = 1:numel (first)
    text(first(k):last(k)) = ' ';
  end
  entries = struct ('name', cell (1, 0), 'types', [], 'text', '', 'place', 0);
  gap = '(?:[ \t]|&[ \t]*\r?\n)+';
  head = ['\<fix', gap, '\S+', gap, '\S+', gap, 'property/global', gap, ...
          '(\w+)', gap, '(scalar|(?:per)?atomtype(?:pair)?)', gap];
  [words, ends] = regexp (text, head, 'tokens', 'end');
  for k = 1:numel (ends)
    rest = text(ends(k) + 1:end);
    rest = regexp (rest, '^(?:[^\n&]|&[ \t]*\r?\n)*', 'match', 'once');
    [values, places] = regexp (rest, '[^\s&"'']+', 'match', 'start');
    entries = [entries, tableOf(words{k}{:}, values, places + ends(k))];
  end
end

function entries = tableOf (name, style, values, places)
  n = numel (values);
  types = num2cell ((1:n)');
  if strcmp (style, 'scalar')
    types = repmat ({zeros(1, 0)}, min (n, 1), 1);
  elseif ~isempty (strfind (style, 'pair'))
    [values, places] = deal (values(2:end), places(2:end));
    size = floor (sqrt (n - 1));
    [second, first] = ind2sub ([size, size], (1:size^2)');
    types = num2cell (sort ([first, second], 2), 2);
  end
  used = 1:min (numel (types), numel (values));
  entries = struct ('name', name, 'types', types(used)', ...
                    'text', values(used), 'place', num2cell (places(used)));
end

%!shared script
%! script = ["fix a all property/global youngsModulus peratomtype 5e6 6e6\n", ...
%!           "# fix f all property/global coefficientFriction ", ...
%!           "peratomtypepair 2 9 9 9 9\n", ...
%!           "fix f all property/global coefficientFriction &\n", ...
%!           " peratomtypepair 2 0.5 ${w} & \n 0.4 .3 # wall\n", ...
%!           "fix v all property/global characteristicVelocity scalar 2.\n", ...
%!           "fix g all gravity 9.81\n"];
%!test
%! [t, name, was] = scriptProperty ({script, ''}, 'friction 2-1');
%! assert ({name, was}, {'friction_1_2', {'${w}', '0.4'}});
%! assert (~isempty (strfind (t{1}, ["2 0.5 ${friction_1_2} & \n ", ...
%!                                   "${friction_1_2} .3 # wall"])));
%! assert (t{2}, '');
%! [t, name] = scriptProperty ({script}, 'youngsModulus 2');
%! assert (~isempty (strfind (t{1}, "peratomtype 5e6 ${youngsModulus_2}\n")));
%! [t, name] = scriptProperty ({script}, 'characteristicVelocity');
%! assert (name, 'characteristicVelocity');
%! assert (~isempty (strfind (t{1}, "scalar ${characteristicVelocity}\n")));
%!assert (scriptProperty ({script}), ...
%!        {'characteristicVelocity', 'friction 1-1', 'friction 1-2', ...
%!         'friction 2-2', 'youngsModulus 1', 'youngsModulus 2'})
%!assert (scriptProperty ({'', 'x'}), cell (1, 0))
%!error id=DEcalioc:scriptProperty:unknownName scriptProperty ({''}, 'friction')
%!error <It has: characteristicVelocity, friction 1-1, friction 1-2>
%! scriptProperty ({script}, 'friction 1-3')
%!error id=DEcalioc:scriptProperty:unknownName
%! scriptProperty ({script}, 'friction')

% SPDX-License-Identifier: GPL-3.0-only
