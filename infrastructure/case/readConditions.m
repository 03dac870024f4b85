% READCONDITIONS  Reads measured.csv, and beside it that of an earlier case.
%
% CALL: [LIST, FAULTS] = readConditions (RAW, MODELS)
%
%   RAW     struct of readInput: folder, and Input, of which reference names the
%           folder of an earlier case ('': none)
%   MODELS, LIST, FAULTS  see readMeasured
%
% With a reference the lines of that case (of its own reference, where it has
% conditions) come first, as the condition reference; the others are the
% condition now.
%
% Reasons: measuredCondition, and those of readMeasured

function [list, p] = readConditions (raw, models)
  [list, p] = readMeasured (fullfile (raw.folder, 'measured.csv'), models);
  reference = givenField (raw.Input, 'reference', '');
  if ~ischar (reference) || isempty (reference) || isempty (list)
    return
  end
  if ~all (cellfun (@isempty, {list.condition}))
    p(end + 1) = checkFault ('measuredCondition', 'Input.reference', ...
                             ['nothing, for measured.csv has the column ' ...
                              'condition'], checkShow (reference), ...
                             'Take one of the two out.');
    return
  end
  [before, q] = readMeasured (fullfile (tilde_expand (reference), ...
                                        'measured.csv'), models);
  p = [p, q];
  if ~isempty (before)
    before = before(ismember ({before.condition}, {'', 'reference'}));
    [before.condition] = deal ('reference');
    [list.condition] = deal ('now');
    list = [before, list];
  end
end

%!test
%! % the values of the earlier case are the reference
%! places = {tempname(), tempname()};
%! for k = 1:2
%!   mkdir (places{k});
%!   writeAtomic (fullfile (places{k}, 'measured.csv'), ...
%!                sprintf ("name,value\na,%d\n", k));
%! end
%! raw = struct ('folder', places{2}, 'Input', struct ('model', 'Toy'));
%! assert ([readConditions(raw, {'Toy'}).value], 2);
%! raw.Input.reference = places{1};
%! [list, p] = readConditions (raw, {'Toy'});
%! assert (isempty (p));
%! assert ({list.condition, list.value}, {'reference', 'now', 1, 2});
%! writeAtomic (fullfile (places{2}, 'measured.csv'), ...
%!              "name,value,condition\na,1,reference\na,2,wet\n");
%! [~, p] = readConditions (raw, {'Toy'});
%! assert (p.id, 'DEcalioc:checkCase:measuredCondition');
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (places{1}, 's');
%! rmdir (places{2}, 's');
