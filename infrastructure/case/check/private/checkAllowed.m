% CHECKALLOWED  Checks the conditions that parameter sets have to satisfy.
%
% CALL: [P, ALLOWED] = checkAllowed (RAW, NAMES, BOX, VALUES)
%
%   RAW      see checkCase: Input.constraints, modelVars, optim.method
%   NAMES    1 x d cell of the names of the parameters
%   BOX      struct: limits, see toUnit
%   VALUES   1 x d cell of their listed values ([]: any)
%   P        1 x n faults, see checkFault
%   ALLOWED  [] where all sets are allowed, else struct: values, rules (cell of
%            handles), texts (cell, the conditions as the user wrote them),
%            share (part of the box that is allowed), sample (m x d, some of
%            these sets); see isAllowed, toAllowed

function [p, allowed] = checkAllowed (raw, names, box, values)
  allowed = [];
  [p, rules, texts] = checkRules (raw, names);
  if isempty (p) && ~isempty ([values{:}, rules])
    box.allowed = struct ('values', {values}, 'rules', {rules}, ...
                          'texts', {texts}, 'share', 1, 'sample', []);
    isPublished = isequal (givenField (raw.optim, 'method', ''), 'published');
    [p, allowed] = checkShare (box, isPublished);
  end
end

function [p, rules, texts] = checkRules (raw, names)
  p = checkFault ();
  [rules, texts] = deal (cell (1, 0));
  given = givenField (raw.Input, 'constraints', {});
  if ~iscell (given)
    given = {given};
  end
  fixed = givenField (raw, 'modelVars', struct ());
  isNumber = structfun (@(v) isKind ('number', v), fixed);
  unused = fieldnames (fixed)(~isNumber);
  fixed = rmfield (fixed, unused);
  for k = 1:numel (given)
    [rule, fault] = oneRule (given{k}, names, fixed);
    if isempty (fault)
      rules{end + 1} = rule;
      texts{end + 1} = strrep (describeValue (given{k}), '''', '');
    else
      field = sprintf ('Input.constraints{%d}', k);
      p(end + 1) = checkFault ('badConstraints', field, ...
                               ['a condition such as ''a + b <= 1'', or a ' ...
                                'handle'], fault, ...
                               ['Write Input.constraints = {''a < b''}; ' ...
                                'with names of assign or modelVars.']);
    end
  end
end

function [rule, fault] = oneRule (given, names, fixed)
  [rule, fault] = deal ([], describeValue (given));
  if isKind ('text', given)
    [rule, fault] = readRule (given, names, fixed);
  elseif isa (given, 'function_handle')
    rule = @(P) ofHandle (given, P, names);
    fault = '';
  end
end

% The user's own code: one set at a time, as a struct.
function yes = ofHandle (f, P, names)
  yes = false (rows (P), 1);
  for i = 1:rows (P)
    set = cell2struct (num2cell (P(i, :)), names, 2);
    yes(i) = logical (f (set));
  end
end

% How much of the box is left, and a sample of it.
function [p, allowed] = checkShare (box, isPublished)
  p = checkFault ();
  [d, allowed] = deal (columns (box.limits), box.allowed);
  for n = [2000, 50000]
    P = fromUnit (integrationPoints (n, d, 1).uniform, box.limits);
    try
      [yes, P] = isAllowed (P, box);
    catch err
      p = checkFault ('badConstraints', 'Input.constraints', ...
                      'a handle that tells of each set whether it may be', ...
                      ['one that ends in: ', err.message], ...
                      'It is called with one struct: f (struct (''a'', 1)).');
      return
    end
    if sum (yes) > 200
      break
    end
  end
  allowed.share = mean (yes);
  allowed.sample = unique (P(yes, :), 'rows', 'stable');
  p = [p, checkLeft(allowed, d, isPublished)];
  allowed.sample = allowed.sample(1:min (end, 500), :);
end

function p = checkLeft (allowed, d, isPublished)
  p = checkFault ();
  field = 'Input.constraints';
  if allowed.share < 0.001
    p = checkFault ('noAllowedSet', field, ...
                    'one in 1000 sets between the limits to be allowed', ...
                    sprintf ('%.2g in 1000', 1000 * allowed.share), ...
                    ['Look at the direction of each condition, or narrow ' ...
                     'paramLims to where sets are allowed.']);
  elseif rows (allowed.sample) < d + 2
    p = checkFault ('fewAllowedSets', field, ...
                    sprintf ('%d different sets to be allowed', d + 2), ...
                    sprintf ('%d', rows (allowed.sample)), ...
                    'Give more values in Input.values, or wider conditions.');
  end
  if isPublished
    p(end + 1) = checkFault ('constraintMethod', 'optim.method', ...
                             ['robust, where Input.constraints or ' ...
                              'Input.values is given'], '''published''', ...
                             'Leave out optim.method or the other one.');
  end
end

%!function [raw, box] = fresh ()
%!  raw.Input = struct ();
%!  raw.optim = struct ();
%!  raw.modelVars = struct ('r', 0.5);
%!  raw.assign = {'a', 'b'};
%!  raw.paramLims = [0, 1; 1, 50];
%!  box = @(raw) nthargout (2, @checkBox, raw);
%!endfunction
%!function reasons = faults (raw)
%!  reasons = regexprep ({checkBox(raw).id}, '.*:', '');
%!endfunction
%!test <*47>
%! [raw, box] = fresh ();
%! raw.Input.constraints = 'a + r < b';
%! raw.Input.values.b = 'integer';
%! here = box (raw);
%! assert (here.allowed.values, {[], 1:50});
%! assert (here.allowed.texts, {'a + r < b'});
%! assert (here.allowed.share, 1 - 0.25 / 49, 0.01);
%! assert (isAllowed (here.allowed.sample, here));
%! raw.Input.constraints = {@(p) p.a < 0.5 && p.b > 3};
%! here = box (raw);
%! assert (isAllowed ([0.4, 4; 0.6, 4; 0.4, 2], here), [true; false; false]);
%!test
%! [raw, box] = fresh ();
%! for bad = {'a', 'a < c', 3, {{'a < b'}}, @(p) p.c < 1, @(p) [1, 2]}
%!   raw.Input.constraints = bad{1};
%!   assert (faults (raw), {'badConstraints'});
%! end
%! raw.Input.constraints = 'a > b';
%! assert (faults (raw), {'noAllowedSet'});
%! raw.Input.constraints = [];
%! for bad = {3, {1}, struct('b', 0), struct('b', [0, 2]), struct('a', 'int')}
%!   raw.Input.values = bad{1};
%!   assert (faults (raw), {'badValues'});
%! end
%! raw.Input.values = {[0, 1], 2};
%! assert (faults (raw), {'badValues'});
%! raw.Input.values = {[0, 1], [2, 3]};
%! raw.Input.constraints = 'a <= b - 2';
%! assert (faults (raw), {'fewAllowedSets'});
%! raw.Input.constraints = 'a <= b';
%! raw.optim.method = 'published';
%! assert (any (strcmp (faults (raw), 'constraintMethod')));

% SPDX-License-Identifier: GPL-3.0-only
