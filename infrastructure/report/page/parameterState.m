% PARAMETERSTATE  What fixes a parameter, or why nothing does.
%
% CALL: [WORD, TEXT, CLASS] = parameterState (C, NAMES, J)
%
%   C      decoded calibration.json
%   NAMES  1 x d cell, names of the parameters
%   J      which of them
%   WORD   'fixed', 'dead', 'trade-off', 'flat direction', 'at a limit',
%          'a compromise' (its value lies outside its interval)
%   TEXT   the reason (HTML)
%   CLASS  'ok', 'unsure' or 'off'
%
% Dead: no calibrated target has a total Sobol index of 0.05 or more for it.
% Trade-off: not fixed, and a correlation above 0.7 with another one.
%
% See also: sectionParameters

function [word, text, class] = parameterState (c, names, j)
  name = names{j};
  loose = any (strcmp (name, cellstr (jsonAt (c, {'notIdentified'}))));
  share = sensitivityOf (c, name);
  [partner, r] = partnerOf (c, names, j);
  limits = jsonAt (c, {'limits', name});
  class = 'ok';
  if any (strcmp (name, cellstr (jsonAt (c, {'atLimit'}))))
    side = 'lower';
    if numel (limits) == 2 && c.params.(name) > mean (limits)
      side = 'upper';
    end
    word = 'at a limit';
    text = sprintf ('at its %s limit; the best value may lie beyond', side);
    class = 'off';
  elseif loose && ~isempty (share) && max (share) < 0.05
    word = 'dead';
    text = 'no target responds to it';
    class = 'unsure';
  elseif loose && ~isempty (partner)
    word = 'trade-off';
    text = sprintf (['only together with %s (correlation %s): more of one ', ...
                     'is made up for by the other'], htmlText (partner), ...
                    numberText (r, 'plain'));
    class = 'unsure';
  elseif loose
    word = 'flat direction';
    text = 'other values fit as well, together with other parameters';
    class = 'unsure';
  elseif isOutside (c, name)
    word = 'a compromise';
    text = ['the value lies outside its interval: no set meets all ', ...
            'targets, and this one misses least; the interval is of the ', ...
            'sets that are likeliest, each target weighed by its noise'];
    class = 'unsure';
  else
    word = 'fixed';
    text = ['by ', strongest(c, share)];
    if ~isempty (partner)
      text = sprintf ('%s; linked to %s (correlation %s)', text, ...
                      htmlText (partner), numberText (r, 'plain'));
    end
  end
end

function yes = isOutside (c, name)
  range = jsonAt (c, {'interval90', name});
  value = c.params.(name);
  yes = numel (range) == 2 && isnumeric (range) && ...
        (value < range(1) || value > range(2));
end

% Shares of the variance of the calibrated targets, NaN for the held-out ones.
function share = sensitivityOf (c, name)
  share = jsonAt (c, {'sensitivity', name})(:)';
  for t = 1:numel (share)
    if ~strcmp (jsonAt (c, {'targets', t, 'role'}), 'calibrate')
      share(t) = NaN;
    end
  end
end

function [partner, r] = partnerOf (c, names, j)
  partner = '';
  r = NaN;
  R = jsonAt (c, {'correlation'});
  if ~isequal (size (R), numel (names) * [1, 1])
    return
  end
  row = R(j, :);
  row(j) = 0;
  [most, k] = max (abs (row));
  if most > 0.7
    partner = names{k};
    r = row(k);
  end
end

function text = strongest (c, share)
  text = 'the targets';
  [~, order] = sort (-share);
  order = order(share(order) >= 0.1);
  if ~isempty (order)
    order = order(1:min (end, 3));
    known = arrayfun (@(t) htmlText (jsonAt (c, {'targets', t, 'name'})), ...
                      order, 'UniformOutput', false);
    text = strjoin (known, ', ');
  end
end

%!shared c, names
%! names = {'a', 'b', 'e', 'f', 'g'};
%! c = jsondecode (['{"params": {"a": 1, "b": 1, "e": 1, "f": 9.99, ', ...
%!   '"g": 1}, "limits": {"f": [0, 10]}, "atLimit": ["f"], ', ...
%!   '"notIdentified": ["b", "e", "g"], "targets": [{"name": "t1", ', ...
%!   '"role": "calibrate"}, {"name": "t2", "role": "holdout"}], ', ...
%!   '"sensitivity": {"a": [0.9, 0], "b": [0.01, 0.9], "e": [0.3, 0], ', ...
%!   '"f": [0.2, 0], "g": [0.2, 0]}, "correlation": [[1,0,0,0,0], ', ...
%!   '[0,1,0,0,0], [0,0,1,0,-0.9], [0,0,0,1,0], [0,0,-0.9,0,1]]}']);
%!test
%! [word, text] = parameterState (c, names, 1);
%! assert (word, 'fixed');
%! assert (text, 'by t1');
%! c.interval90.a = [2; 3];
%! assert (parameterState (c, names, 1), 'a compromise');
%! % it moves a held-out target only
%! assert (parameterState (c, names, 2), 'dead');
%! [word, text] = parameterState (c, names, 3);
%! assert (word, 'trade-off');
%! assert (! isempty (strfind (text, 'with g')));
%! [word, text] = parameterState (c, names, 4);
%! assert (word, 'at a limit');
%! assert (! isempty (strfind (text, 'upper')));
%! c.correlation = [];
%! assert (parameterState (c, names, 5), 'flat direction');
