% Rolling friction in pair_style, and in no fix wall/gran: the parameter of grain and
% wall changed no digit, and the advice was to measure it.

%!test
%! folder = reportedCase ('inertWallRolling');
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 0, out);
%! assert (! isempty (regexp (out, ['WARNING +Pile: the rolling friction of types 1-2 ' ...
%!                                  'is set .*but no contact model'])), out);
%! % one wall that reads it is enough
%! file = fullfile (folder, 'DEMmodels', 'Pile', 'in.pile');
%! writeAtomic (file, strrep (fileread (file), 'history primitive type 2 zplane', ...
%!                            'history rolling_friction epsd2 primitive type 2 zplane'));
%! [~, out] = startCommand (folder, 'check');
%! assert (isempty (strfind (out, 'no contact model')), out);

% SPDX-License-Identifier: GPL-3.0-only
