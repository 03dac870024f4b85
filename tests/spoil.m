% SPOIL  Changes one thing in the input of checkCase, for tests.
%
% CALL: RAW = spoil (RAW, PATH, VALUE)
%
%   RAW    input of checkCase
%   PATH   what is set, e.g. 'optim.tolRes{1}(2)'; '-Input.cpu' takes a field
%          out; with '' VALUE is a function that maps RAW to RAW
%   VALUE  what is put there
%
% See also: badInputs, goodInput

function raw = spoil (raw, path, value)
  if isempty (path)
    raw = value (raw);
  elseif path(1) == '-'
    raw = takeOut (raw, steps (path(2:end)));
  else
    raw = subsasgn (raw, steps (path), value);
  end
end

function raw = takeOut (raw, s)
  if isscalar (s)
    raw = rmfield (raw, s.subs);
  else
    raw = subsasgn (raw, s(1:end - 1), ...
                    rmfield (subsref (raw, s(1:end - 1)), s(end).subs));
  end
end

% 'a.b{1}(:, 2)' as substruct has it.
function s = steps (path)
  words = regexp (['.', path], '\.\w+|\{\d+\}|\([\d:, ]+\)', 'match');
  s = struct ('type', cell (1, 0), 'subs', []);
  for k = 1:numel (words)
    word = words{k};
    inside = strsplit (word(2:end - 1), ', ');
    for i = find (~strcmp (inside, ':'))
      inside{i} = str2double (inside{i});
    end
    switch word(1)
      case '.'
        s(end + 1) = struct ('type', '.', 'subs', word(2:end));
      case '{'
        s(end + 1) = struct ('type', '{}', 'subs', {inside});
      otherwise
        s(end + 1) = struct ('type', '()', 'subs', {inside});
    end
  end
end

%!shared raw
%! raw = struct ('a', struct ('b', {{[1, 2], 3}}), 'c', [1, 2; 3, 4]);
%!assert (spoil (raw, 'a.b{1}(2)', 9).a.b, {[1, 9], 3})
%!assert (spoil (raw, 'c(:, 2)', 0).c, [1, 0; 3, 0])
%!assert (fieldnames (spoil (raw, '-a', [])), {'c'})
%!assert (isempty (fieldnames (spoil (raw, '-a.b', []).a)))
%!assert (spoil (raw, '', @(r) 7), 7)

% SPDX-License-Identifier: GPL-3.0-only
