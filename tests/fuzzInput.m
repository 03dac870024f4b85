% FUZZINPUT  Tries random damage on inputs and reports what is not caught.
%
% CALL: [FINDINGS, COUNTS] = fuzzInput (N, SEED, SHARE)
%
%   N         number of tries
%   SEED      integer; the same seed makes the same tries
%   SHARE     part of the inputs found good that is also given to newCase
%   FINDINGS  1 x m cell of texts: an error that checkCase or newCase did not
%             turn into one of DEcalioc, or a text of the input that was run
%   COUNTS    1 x 3: tries with faults, without, given to newCase
%
% See also: fuzzValue, goodInput, checkCase

function [findings, counts] = fuzzInput (n, seed, share)
  rand ('twister', seed);
  randn ('twister', seed);
  place = tempname ();
  canary = [place, '.canary'];
  bases = {goodInput([place, 'a']), goodPublished([place, 'b'])};
  findings = {};
  counts = zeros (1, 3);
  for k = 1:n
    raw = damaged (pick (bases), canary);
    [text, how] = try1 (raw, rand () < share);
    counts = counts + how;
    if ~isempty (text)
      findings{end + 1} = sprintf ('try %d of seed %d: %s', k, seed, text);
    end
  end
  if isfile (canary)
    findings{end + 1} = 'a text of the input was run by a shell or by Octave';
  end
  confirm_recursive_rmdir (false, 'local');
  rmdir ([place, 'a'], 's');
  rmdir ([place, 'b'], 's');
end

function [text, how] = try1 (raw, alsoCase)
  text = '';
  how = [1, 0, 0];
  try
    lastwarn ('', '');
    p = checkCase (raw, 'noPrograms');
    text = noise ();
    if isempty (p)
      how = [0, 1, alsoCase];
      text = [text, caseFault(raw, alsoCase)];
    elseif any (strcmp ({p.id}, 'DEcalioc:checkCase:checkFailed'))
      text = strjoin ({p.message}, ' ');
    elseif ~all (cellfun (@ischar, {p.message}))
      text = 'a message that is no text';
    end
  catch err
    text = ['checkCase throws: ', err.message];
  end
end

% The warning that the user would have seen, if any.
function text = noise ()
  text = '';
  [message, id] = lastwarn ();
  if ~isempty (message) && strcmp (warning ('query', id).state, 'on')
    text = ['checkCase warns: ', message];
  end
end

function text = caseFault (raw, alsoCase)
  text = '';
  if ~alsoCase
    return
  end
  try
    Case = newCase (raw);
    if isfield (raw, 'effects')
      withEffects (Case, raw.effects);
    end
  catch err
    if ~strncmp (err.identifier, 'DEcalioc:', 9)
      text = sprintf ('newCase throws %s: %s (%s, line %d)', ...
                      err.identifier, err.message, err.stack(1).name, ...
                      err.stack(1).line);
    end
  end
end

function raw = damaged (raw, canary)
  for i = 1:ceil (3 * rand ())
    if isscalar (raw)
      raw = damage (raw, 0, canary);
    end
  end
end

% Walks down at random and damages one place.
function value = damage (value, depth, canary)
  isOne = isstruct (value) && isscalar (value);
  hasNumbers = isnumeric (value) && ~isempty (value);
  if isOne && rand () < 0.8 + (depth == 0)
    value = damageStruct (value, depth, canary);
  elseif iscell (value) && ~isempty (value) && rand () < 0.7
    k = ceil (numel (value) * rand ());
    value{k} = damage (value{k}, depth + 1, canary);
  elseif hasNumbers && rand () < 0.6
    k = ceil (numel (value) * rand ());
    value(k) = damageNumber (double (value(k)));
  elseif ischar (value) && rand () < 0.6
    value = damageText (value);
  else
    value = damageWhole (value, canary);
  end
end

function s = damageStruct (s, depth, canary)
  names = fieldnames (s);
  if isempty (names)
    s.new = fuzzValue (2, canary);
    return
  end
  name = pick (names);
  dice = rand ();
  if dice < 0.05 && ~any (strcmp (name, {'folder', 'root'}))
    s = rmfield (s, name);
  elseif dice < 0.1
    s.(damageText (name)) = s.(name);
  elseif dice < 0.12
    s = [s, s];
  elseif ~any (strcmp (name, {'folder', 'root'})) || rand () < 0.1
    s.(name) = damage (s.(name), depth + 1, canary);
  end
end

function x = damageNumber (x)
  others = {NaN, Inf, -Inf, 0, -x, x + 0.5, 1e300, eps, x * 1000, ...
            x / 1000, realmax, 1, 2, 3, round(10 * rand ())};
  x = pick (others);
end

function text = damageText (text)
  bits = {'''', '"', "\n", char(0), char([195, 164]), char(255), '..', ...
          '/', ';', '$(id)', ' ', '%d', '\', 'x', 'P', ''};
  bit = pick (bits);
  text = text(:)';
  at = floor ((numel (text) + 1) * rand ());
  skip = rand () < 0.3;
  text = [text(1:at), bit, text(at + 1 + skip:end)];
end

function value = damageWhole (value, canary)
  casts = {@(v) {v}, @(v) [v; v], @(v) v.', @(v) v(:), @(v) v([]), ...
           @int32, @single, @uint8, @logical, @(v) sparse(double (v)), ...
           @(v) complex(double (v), 1), @(v) repmat(v, 2, 2), ...
           @(v) cat(3, v, v), @num2cell, @(v) setfield(struct (), 'v', v), ...
           @(v) {v; v}, @(v) v{1}, @(v) 1:numel (v)};
  cast = pick (casts);
  if rand () < 0.5
    value = fuzzValue (0, canary);
    return
  end
  try
    value = cast (value);
  catch
    value = fuzzValue (1, canary);
  end
end

function value = pick (values)
  k = ceil (numel (values) * rand ());
  value = values{k};
end

%!test
%! findings = fuzzInput (20, 5, 0);
%! assert (isempty (findings), strjoin ([findings, {''}], "\n"));

% SPDX-License-Identifier: GPL-3.0-only
