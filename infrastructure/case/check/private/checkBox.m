% CHECKBOX  Checks in which scale, where and at which values sets may lie.
%
% CALL: [P, BOX] = checkBox (RAW)
%
%   RAW  see checkCase: Input.scale, Input.values, Input.constraints, assign,
%        paramLims, modelVars
%   P    1 x n faults, see checkFault
%   BOX  struct for newCase: limits (see toUnit), bySelf (1 x d logical: in
%        logarithms without having been asked for), allowed (see
%        checkAllowed); [] where names or limits make no sense
%
% A parameter counts in logarithms where Input.scale says so, or, where it says
% nothing, between positive limits that are more than a factor of 100 apart
% (not with optim.method 'published').

function [p, box] = checkBox (raw)
  p = checkFault ();
  box = [];
  names = raw.assign;
  if ~iscell (names) || ~all (cellfun (@(a) isKind ('name', a), names(:)))
    return
  end
  names = names(:)';
  limits = raw.paramLims;
  if ~isnumeric (limits) || ~isreal (limits) || ...
     ~isequal (size (limits), [2, numel(names)]) || ...
     ~all (diff (double (limits)) > 0)
    return
  end
  % no set that lies on a limit is beyond it when it is rounded
  limits = toDigits (double (limits));
  isPublished = isequal (givenField (raw.optim, 'method', ''), 'published');
  [p, isLog, bySelf] = checkScale (raw.Input, names, limits, isPublished);
  box = struct ('limits', limits, 'bySelf', bySelf, 'allowed', []);
  if any (isLog)
    box.limits(3, :) = isLog;
  end
  [q, values] = checkValues (raw.Input, names, limits);
  [r, box.allowed] = checkAllowed (raw, names, box, values);
  p = [p, q, r];
end

function [p, isLog, bySelf] = checkScale (Input, names, limits, isPublished)
  cure = 'Write Input.scale.youngsModulusP = ''log''; or leave it out.';
  [p, given] = byName (Input, 'scale', names, cure);
  words = cellfun (@(g) find (strcmp (g, {'log', 'linear'})), given, ...
                   'UniformOutput', false);
  isGiven = ~cellfun (@isempty, given);
  bad = isGiven & cellfun (@isempty, words);
  for j = find (bad)
    p(end + 1) = checkFault ('badScale', ['Input.scale.', names{j}], ...
                             '''log'' or ''linear''', describeValue (given{j}), ...
                             cure);
  end
  isAsked = cellfun (@(w) isequal (w, 1), words);
  for j = find (isAsked & limits(1, :) <= 0)
    p(end + 1) = checkFault ('badScale', ['Input.scale.', names{j}], ...
                             '''linear'', as a limit is not above 0', ...
                             '''log''', ['Raise the lower limit above 0, ' ...
                                         'or leave the scale out.']);
  end
  bySelf = ~isGiven & limits(1, :) > 0 & ...
           limits(2, :) > 100 * limits(1, :) & ~isPublished;
  isLog = isAsked | bySelf;
end

function [p, values] = checkValues (Input, names, limits)
  cure = ['Write Input.values.nSpheres = 1:4; or = ''integer''; or leave ' ...
          'it out.'];
  [p, given] = byName (Input, 'values', names, cure);
  values = cell (1, numel (names));
  for j = find (~cellfun (@isempty, given))
    v = given{j};
    if isequal (v, 'integer')
      v = ceil (limits(1, j)):min (floor (limits(2, j)), limits(1, j) + 1e4);
    end
    isGood = isKind ('vector', v) && all (isfinite (v)) && ...
             all (v >= limits(1, j) & v <= limits(2, j));
    if ~isGood || numel (unique (v)) < 2
      p(end + 1) = checkFault ('badValues', ['Input.values.', names{j}], ...
                               ['two or more numbers between the limits, ' ...
                                'or ''integer'''], describeValue (given{j}), cure);
    else
      values{j} = unique (toDigits (double (v(:)')));
    end
  end
end

% A field of Input that says something of some parameters: a struct by name, or
% a cell, one element a parameter. GIVEN 1 x d cell, [] where it says nothing.
function [p, given] = byName (Input, field, names, cure)
  p = checkFault ();
  given = cell (1, numel (names));
  list = givenField (Input, field, []);
  if isempty (list)
    return
  elseif iscell (list) && numel (list) == numel (names)
    given = list(:)';
  elseif isKind ('struct', list)
    for name = fieldnames (list)'
      j = find (strcmp (name{1}, names));
      if isempty (j)
        p(end + 1) = checkFault ('unknownParam', ...
                                 ['Input.', field, '.', name{1}], ...
                                 'a design variable of assign', ...
                                 'another name', ...
                                 strtrim ([checkNearest(name{1}, names), ...
                                           ' ', cure]));
      else
        given{j} = list.(name{1});
      end
    end
  else
    p = checkFault (['bad', upper(field(1)), field(2:end)], ...
                    ['Input.', field], sprintf (['a struct with names of ' ...
                                                 'assign, or a cell of %d'], ...
                                                numel (names)), ...
                    describeValue (list), cure);
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
%!test
%! [raw, box] = fresh ();
%! assert (box (raw), struct ('limits', [0, 1; 1, 50], ...
%!                            'bySelf', [false, false], 'allowed', []));
%!test <*47>
%! [raw, box] = fresh ();
%! raw.paramLims = [1e5, 1; 1e9, 50];
%! assert (box (raw).limits, [raw.paramLims; 1, 0]);
%! assert (box (raw).bySelf, [true, false]);
%! raw.Input.scale = struct ('a', 'linear', 'b', 'log');
%! assert (box (raw).limits, [raw.paramLims; 0, 1]);
%! raw.Input.scale = {'log', []};
%! assert (box (raw).bySelf, [false, false]);
%! assert (box (raw).limits, [raw.paramLims; 1, 0]);
%! raw.Input.scale = [];
%! raw.optim.method = 'published';
%! assert (rows (box (raw).limits), 2);
%!test
%! [raw, box] = fresh ();
%! for bad = {'log', {'log'}, {'log', 'log'}, struct('b', 'lag'), ...
%!            struct('b', 3), {[], 'x'}}
%!   raw.Input.scale = bad{1};
%!   assert (faults (raw), {'badScale'});
%! end
%! raw.Input.scale = struct ('c', 'log');
%! assert (faults (raw), {'unknownParam'});
%!test
%! [raw, box] = fresh ();
%! raw.assign = 3;
%! assert ({isempty(checkBox (raw)), box(raw)}, {true, []});
%! raw.assign = {'a', 'b'};
%! raw.paramLims = [3, 1; 1, 50];
%! assert (box (raw), []);

% SPDX-License-Identifier: GPL-3.0-only
