% The script asks for 900 grains in a region that takes 242: LIGGGHTS warns of it, and
% the trial said ok without a word.

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! folder = reportedCase ('fewerInserted');
%! [status, out] = startCommand (folder, 'check --try');
%! assert (status == 0, out);
%! assert (! isempty (regexp (out, 'grains: 24\d of 900 that the script asks for')), out);
%! assert (! isempty (regexp (out, ['WARNING +Pile: LIGGGHTS says: Particle insertion: ' ...
%!                                  'Less insertions than requested'])), out);

% SPDX-License-Identifier: GPL-3.0-only
