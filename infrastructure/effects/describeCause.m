% DESCRIBECAUSE  Fills the description of a cause, of which effects are the work.
%
% CALL: CAUSE = describeCause (GIVEN)
%
%   GIVEN  scalar struct with name, label, question (texts; what a person asks
%          for), members (m x 4 cell: effects, names of which the first one that
%          the case lists counts; group, '' or that of an effect of the user's
%          own; share and spread, mean and standard deviation of its strength,
%          in shares of its range, where the cause acts in full)
%   CAUSE  scalar struct: the same, and
%            oneOf    logical, its members act one at a time, not together (false)
%            usually  'yes', or 'unlikely' where the grains are the same ones
%            source   where members and shares come from
%
% The first member is the lead: without it in the list of the case, the cause
% cannot be weighed (of one that acts by one of its members: without any).
%
% Errors: DEcalioc:describeCause:missingField, :badShape
%
% See also: listCauses, weighCauses, describeEffect

function cause = describeCause (given)
  needed = {'name', 'label', 'question', 'members'};
  missing = needed(~isfield (given, needed));
  if ~isempty (missing)
    error ('DEcalioc:describeCause:missingField', ...
           'describeCause: GIVEN must have the field %s.', missing{1});
  end
  cause = mergeFields (struct ('oneOf', false, 'usually', 'yes', ...
                               'source', ''), given);
  if ~iscell (cause.members) || columns (cause.members) ~= 4
    error ('DEcalioc:describeCause:badShape', ...
           ['describeCause: members of %s must be m x 4 (effects, group, ' ...
            'share, spread), got %d x %d.'], cause.name, ...
           size (cause.members));
  end
  cause.members = cell2struct (cause.members, ...
                               {'effects', 'group', 'share', 'spread'}, 2)';
end

%!test
%! c = describeCause (struct ('name', 'x', 'label', 'l', 'question', 'q?', ...
%!                            'members', {{{'a', 'b'}, '', 0.5, 0.2}}));
%! assert ({c.oneOf, c.usually, c.members.effects}, ...
%!         {false, 'yes', {'a', 'b'}});
%!error id=DEcalioc:describeCause:missingField
%! describeCause (struct ('name', 'x'))
%!error id=DEcalioc:describeCause:badShape
%! describeCause (struct ('name', 'x', 'label', 'l', 'question', 'q?', ...
%!                        'members', {{'a', 0.5}}))

% SPDX-License-Identifier: GPL-3.0-only
