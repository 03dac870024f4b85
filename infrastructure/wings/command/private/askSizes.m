% ASKSIZES  The sizes of a test rig, in the words and units of whoever has one.
%
% CALL: SIZES = askSizes (BENCH, DENSITY, ASK)
%
%   BENCH    one of listBenches
%   DENSITY  of a grain, kg/m3
%   ASK      see newBenchCase
%   SIZES    BENCH.sizes with the values (texts) that were said
%
% A radius is asked for as a diameter, a speed in rad/s in turns per minute, solid
% volume as mass (in a tube also as height), height or share of the filling, of which
% grains fill 0.6.

function sizes = askSizes (bench, density, ask)
  sizes = bench.sizes;
  for k = 1:numel (sizes)
    how = howAsked (sizes(k), sizes, density);
    if isempty (how)
      continue
    end
    how.perHeight = massPerHeight (sizes, density);
    usual = sprintf ('%.4g', str2double (sizes(k).value) / how.factor);
    said = ask (sprintf ('%s: %s%s', bench.name, how.label, ...
                         regexprep (how.unit, {'^(?=.)', 'rpm', ', 1$'}, ...
                                    {', ', 'turns per minute', ''}, 'emptymatch')), ...
                usual, @(text) sizeAs (text, how));
    if ~strcmp (said, usual)
      sizes(k).value = sprintf ('%.6g', how.factor * str2double (said));
    end
  end
end

% Of what fills the tube, kg/m.
function mass = massPerHeight (sizes, density)
  mass = [];
  isTube = strcmp ({sizes.name}, 'tubeRadius');
  if any (isTube)
    mass = 0.6 * density * pi * str2double (sizes(isTube).value)^2;
  end
end

% A share of the volume is said in both terms: a slip between them passes any band.
function [text, fault, echo] = sizeAs (text, how)
  said = text;
  [text, fault, echo] = sizeIn (said, how.unit);
  [height, noHeight] = sizeIn (said, 'm');
  isTube = strcmp (how.unit, 'kg') && ~isempty (how.perHeight);
  if isTube && ~isempty (fault) && isempty (noHeight)
    text = sprintf ('%.6g', how.perHeight * str2double (height));
    [fault, echo] = deal ('', sprintf ('%.4g g in a tube of that diameter', ...
                                       1000 * str2double (text)));
  end
  if strcmp (how.unit, '1') && isempty (fault)
    share = 100 * str2double (text);
    echo = sprintf ('%.3g %% for the bed with its voids, %.3g %% solid', share, ...
                    how.factor * share);
  end
end

% LABEL, UNIT and FACTOR (by which what is said is multiplied); [] for what no user
% would change here.
function how = howAsked (one, sizes, density)
  remark = one.remark;
  if isempty (remark)                    % speed2, as speed1
    first = strcmp ({sizes.name}, regexprep (one.name, '\d+$', '1'));
    remark = [sizes(first).remark, ''];
  end
  words = lower (regexprep (one.name, {'([A-Z])', '(\d+)$'}, {' $1', ' $1'}));
  stem = regexprep (words, ' (radius|solid)$', '');
  % name, remark, label, unit, factor
  rules = {'^tubeRadius$', '^m\>', 'inner tube diameter', 'm', 0.5; ...
           '^plateRadius$', '^m\>', ['plate diameter (rough; the heap ends at its edge, ' ...
                                     'what falls off is not weighed)'], 'm', 0.5; ...
           '^liftHeight$', '^m\>', 'lift height (clear of the heap; more costs time)', ...
           'm', 1; ...
           'Radius$', '^m\>', [stem, ' diameter'], 'm', 0.5; ...
           '^speed\d', '^rad/s', words, 'rpm', pi / 30; ...
           'Solid$', '^m3', 'mass filled into the tube, or height in it', 'kg', 1 / density; ...
           'Solid$', '^m\>', 'height of the filling', 'm', 0.6; ...
           'Solid$', 'volume', ['share of the volume that the bed fills, voids ' ...
                                'included (22 % solid: 0.37)'], '1', 0.6; ...
           '', '^(m|m/s|Pa)(,|$)', words, regexp(remark, '^[^,]*', 'match', 'once'), 1};
  how = [];
  for row = rules(end:-1:1, :)'
    if ~isempty (regexp (one.name, row{1}, 'once', 'emptymatch')) && ...
       ~isempty (regexp (remark, row{2}, 'once'))
      how = cell2struct (row(3:5), {'label', 'unit', 'factor'});
    end
  end
end

%!function text = answer (question, usual, rule, said)
%!  text = usual;
%!  k = find (cellfun (@(part) ~isempty (strfind (question, part)), said(:, 1)), 1);
%!  if ~isempty (k)
%!    [text, fault] = rule (said{k, 2});
%!    assert (fault, '');
%!  end
%!endfunction
%!shared root
%! root = fileparts (fileparts (which ('startToolbox')));
%!test
%! said = {'tube diameter', '36 mm'; 'plate diameter', '0.08'; 'mass filled', '24 g'; ...
%!         'speed 1, turns per minute', '10'; 'speed 2', '3.14159 rad/s'; ...
%!         'share of the', '35 %'; 'height of the', '50 mm'; 'slot 1', '25 mm'};
%! ask = @(question, usual, rule) answer (question, usual, rule, said);
%! wanted = {'Heap', 'tubeRadius', 0.018; 'Heap', 'plateRadius', 0.04; ...
%!           'Heap', 'heapSolid', 2e-5; 'Heap', 'liftSpeed', 0.12; ...
%!           'Drum', 'speed1', 1.0472; 'Drum', 'speed2', 3.14159; 'Drum', 'speed3', 8; ...
%!           'Drum', 'drumSolid', 0.21; 'SlotBin', 'binSolid', 0.03; ...
%!           'SlotBin', 'slot1', 0.025; 'Shear', 'load1', 300; 'Collapse', 'columnSolid', 0.03};
%! for row = wanted'
%!   sizes = askSizes (listBenches (root, row(1)), 1200, ask);
%!   value = str2double (sizes(strcmp ({sizes.name}, row{2})).value);
%!   assert (value, row{3}, 1e-4 * row{3});
%! end
%! % Enter takes all as they are
%! bench = listBenches (root, {'Heap'});
%! assert (isequal (askSizes (bench, 1200, @(q, usual, rule) usual), bench.sizes));
%!function text = typed (question, usual, rule)
%!  [text, ~, echo] = rule (usual);
%!  if ~isempty (strfind (question, 'share'))
%!    assert (question, ['Drum: share of the volume that the bed fills, voids included ' ...
%!                       '(22 % solid: 0.37)']);
%!    [text, ~, echo] = rule ('0.22');
%!    assert (echo, '22 % for the bed with its voids, 13.2 % solid');
%!  end
%!endfunction
%!test
%! % the height in a tube of 30 mm, grains of 1200 kg/m3 in 0.6 of it
%! ask = @(question, usual, rule) answer (question, usual, rule, {'height in it', '60 mm'});
%! sizes = askSizes (listBenches (root, {'Heap'}), 1200, ask);
%! value = str2double (sizes(strcmp ({sizes.name}, 'heapSolid')).value);
%! assert (value, 0.6 * pi * 0.015^2 * 0.06, 1e-4 * value);
%!test
%! % 22 % solid typed as the share of the bed: the echo shows it
%! sizes = askSizes (listBenches (root, {'Drum'}), 1200, @typed);
%! assert (str2double (sizes(strcmp ({sizes.name}, 'drumSolid')).value), 0.132);

% SPDX-License-Identifier: GPL-3.0-only
