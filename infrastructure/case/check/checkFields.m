% CHECKFIELDS  Checks the fields of a struct against a table.
%
% CALL: [P, UNREAD] = checkFields (S, PREFIX, KNOWN)
%       [P, UNREAD] = checkFields (S, PREFIX, KNOWN, RULES)
%       [P, UNREAD] = checkFields (S, PREFIX, KNOWN, RULES, N)
%
%   S       scalar struct
%   PREFIX  how the user writes it, e.g. 'Input' (text)
%   KNOWN   cell of the names of fields that are read and have no rule
%   RULES   n x 7 cell, one row a field: name, reason, low, high, kind, needed
%           (true or false: may be missing or empty), cure (text). Kinds:
%           'integer' and 'number' from low to high, 'open' between them;
%           'other': low is what is expected (text), high a handle that tells
%           whether a value is good; 'models': the same for each element of a
%           vector, one a model
%   N       number of models, 0: not known; more values, or fewer that are
%           needed, are the fault <name>Count
%   P       1 x n faults, see checkFault
%   UNREAD  1 x m cell of the names that are near none of the table, which a
%           file of the user may read; asked for, they are no faults

function [p, unread] = checkFields (s, prefix, known, rules, n)
  if nargin < 4
    rules = cell (0, 7);
  end
  if nargin < 5
    n = 0;
  end
  known = [known, rules(:, 1)'];
  p = checkFault ();
  unread = cell (1, 0);
  given = fieldnames (s)';
  for name = given(~ismember (given, known))
    cure = checkNearest (name{1}, known);
    if isempty (cure) && nargout > 1
      unread = [unread, name];
      continue
    elseif isempty (cure)
      cure = 'Take it out; docs/inputs.md lists all fields.';
    end
    p(end + 1) = checkFault ('unknownField', [prefix, '.', name{1}], ...
                             ['one of the fields of ', prefix], ...
                             'a field that nothing reads', cure);
  end
  for rule = rules'
    p = [p, checkRule(s, prefix, rule, n)];
  end
end

function p = checkRule (s, prefix, rule, n)
  p = checkFault ();
  [name, reason, low, high, kind, needed, cure] = rule{:};
  field = [prefix, '.', name];
  isGiven = isfield (s, name);
  if isGiven && isGood (s.(name), low, high, kind)
    p = checkCount (numel (s.(name)), n * strcmp (kind, 'models'), rule, field);
  elseif isGiven && (needed || ~isKind ('nothing', s.(name)))
    p = checkFault (reason, field, expected (low, high, kind), ...
                    describeValue (s.(name)), cure);
  elseif needed
    p = checkFault ('missingField', field, expected (low, high, kind), ...
                    'nothing', cure);
  end
end

function yes = isGood (value, low, high, kind)
  if strcmp (kind, 'other')
    yes = high (value);
  elseif strcmp (kind, 'models')
    yes = isKind ('vector', value) && all (high (value));
  else
    yes = isKind ('number', value) && value >= low && value <= high && ...
          ~(strcmp (kind, 'integer') && value ~= fix (value)) && ...
          ~(strcmp (kind, 'open') && any (value == [low, high]));
  end
end

function text = expected (low, high, kind)
  if ischar (low)
    text = low;
  elseif strcmp (kind, 'open')
    text = sprintf ('a number between %.10g and %.10g', low, high);
  else
    what = {'a number', 'an integer'};
    text = sprintf ('%s from %.10g to %.10g', ...
                    what{1 + strcmp(kind, 'integer')}, low, high);
  end
end

function p = checkCount (given, n, rule, field)
  p = checkFault ();
  if n > 0 && (given > n || (rule{6} && given < n))
    most = repmat ('at most ', 1, ~rule{6});
    p = checkFault ([rule{1}, 'Count'], field, ...
                    sprintf ('%s%d value(s), one a model', most, n), ...
                    sprintf ('%d value(s)', given), rule{7});
  end
end

%!shared rules, ids
%! rules = {'n', 'badN', 1, 9, 'integer', true, 'Set n = 2.'; ...
%!          'x', 'badX', 0, 1, 'open', false, 'Set x = 0.5.'; ...
%!          't', 'badT', 'seconds', @(t) t > 0, 'models', false, 'Set t.'};
%! ids = @(p) strrep ({p.id}, 'DEcalioc:checkCase:', '');
%!test
%! check = @(s) checkFields (s, 'optim', {'sed'}, rules, 2);
%! good = struct ('n', 3, 'x', [], 't', [1, 2], 'sed', 7);
%! assert (isempty (check (good)));
%! assert (ids (check (struct ('x', 0))), {'missingField', 'badX'});
%! assert (check (setfield (good, 'x', 1)).message, ['optim.x in ', ...
%!   'loadInput.m: expected a number between 0 and 1, got 1. Set x = 0.5.']);
%! assert (ids (check (setfield (good, 'n', 2.5))), {'badN'});
%! assert (ids (check (setfield (good, 't', [1, 2, 3]))), {'tCount'});
%! assert (ids (check (setfield (good, 't', -1))), {'badT'});
%!test
%! % a field of the user's own is a fault only where it may not be there
%! s = struct ('sed', 1, 'colour', 2);
%! assert (numel (checkFields (s, 'Input', {'cpu', 'seed'})), 2);
%! [p, unread] = checkFields (s, 'Input', {'cpu', 'seed'});
%! assert (ids (p), {'unknownField'});
%! assert (! isempty (strfind (p.message, 'Did you mean seed?')));
%! assert (unread, {'colour'});

% SPDX-License-Identifier: GPL-3.0-only
